#include "cli/commands.h"
#include "cli/output.h"
#include "cli/recognition_text.h"
#include "cli/recognize_recording.h"
#include "robot/input/demonstration.h"

namespace tact::cli {

ExitStatus RunRecognize(const RecognizeOptions& options) {
  if (IsRecording(options)) return RunRecognizeRecording(options);
  if (!options.page.empty() || !options.states.empty())
    throw InputError(std::string(options.page.empty() ? "--states" : "--output") +
                     ": expected a recording, got a demonstration that is exact; --noisy treats it as one");
  input::InputFile file(options.file);
  const recognition::Recognition recognition =
      recognition::Recognize(input::ReadDemonstration(file.stream(), file.name()));
  for (const std::string& note : recognition.notes) Note(note);
  Output output;
  output << (options.json ? "{" + ToJsonMembers(recognition) + "}\n" : ToText(recognition));
  output.Flush();
  return kAnswered;
}

}  // namespace tact::cli
