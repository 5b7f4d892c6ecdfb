// See vtk_messages.h.
#include "app/session/vtk_messages.h"

#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

#include <set>

#include "app/session/messages.h"

namespace {

/// Keeps a report short: VTK appends whole shader sources to some.
std::string shortened(const char* text) {
  constexpr std::size_t most = 400;
  std::string line = boxprobe::singleLine(text == nullptr ? "" : text);
  if (line.size() > most) line = line.substr(0, most) + " ...";
  return line;
}

class vtkSingleLineOutputWindow : public vtkOutputWindow {
 public:
  static vtkSingleLineOutputWindow* New();

  void DisplayErrorText(const char* text) override {
    const std::string line = "VTK: " + shortened(text);
    if (this->FirstError.empty()) this->FirstError = line;
    if (this->PrintErrors && this->Seen.insert(line).second) boxprobe::printError(line);
  }
  void DisplayWarningText(const char* text) override {
    const std::string line = "VTK: " + shortened(text);
    if (!this->Quiet && this->Seen.insert(line).second) boxprobe::printWarnings({line});
  }
  void DisplayGenericWarningText(const char* text) override { this->DisplayWarningText(text); }
  void DisplayText(const char* text) override { this->DisplayWarningText(text); }
  void DisplayDebugText(const char*) override {}

  bool Quiet = false;
  bool PrintErrors = false;
  std::string FirstError;

 protected:
  std::set<std::string> Seen;  ///< a report repeated at every frame is printed once
};
vtkStandardNewMacro(vtkSingleLineOutputWindow);

}  // namespace

namespace boxprobe {

void installVtkMessages(bool quiet, bool printErrors) {
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);  // the logger would print every report a second time
  vtkNew<vtkSingleLineOutputWindow> window;
  window->Quiet = quiet;
  window->PrintErrors = printErrors;
  vtkOutputWindow::SetInstance(window);
}

std::string firstVtkError() {
  const auto* window = dynamic_cast<vtkSingleLineOutputWindow*>(vtkOutputWindow::GetInstance());
  return window == nullptr ? "" : window->FirstError;
}

}  // namespace boxprobe
