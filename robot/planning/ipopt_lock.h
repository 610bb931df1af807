/// @file
/// One Ipopt solve at a time: its linear solver, MUMPS, keeps what it knows in globals.
#pragma once

#include <mutex>

namespace tact {

/// To be held from before an application is made until it is gone.
inline std::unique_lock<std::mutex> LockIpopt() {
  static std::mutex mutex;
  return std::unique_lock(mutex);
}

}  // namespace tact
