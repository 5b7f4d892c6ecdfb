#include "filters/vtk/import/vtk_error_catcher.h"

#include <vtkLogger.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include "filters/core/base/one_line.h"

namespace boxprobe {

class vtkFirstErrorWindow : public vtkOutputWindow {
 public:
  static vtkFirstErrorWindow* New();
  vtkTypeMacro(vtkFirstErrorWindow, vtkOutputWindow) void DisplayText(const char*) override {}
  void DisplayErrorText(const char* text) override {
    if (this->First.empty()) this->First = text;
  }
  std::string First;
};
vtkStandardNewMacro(vtkFirstErrorWindow);

struct VtkErrorCatcher::Impl {
  vtkSmartPointer<vtkOutputWindow> before;
  vtkSmartPointer<vtkFirstErrorWindow> window;
};

VtkErrorCatcher::VtkErrorCatcher() : impl_(new Impl) {
  // VTK also logs to stderr what it sends to its output window. This stays off: the program has its own messages.
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  impl_->before = vtkOutputWindow::GetInstance();
  impl_->window = vtkSmartPointer<vtkFirstErrorWindow>::New();
  vtkOutputWindow::SetInstance(impl_->window);
}

VtkErrorCatcher::~VtkErrorCatcher() {
  vtkOutputWindow::SetInstance(impl_->before);
  delete impl_;
}

// "ERROR: In FILE, line N\nvtkClass (0x...): what\n\n"
std::string VtkErrorCatcher::error() const {
  std::string text = impl_->window->First;
  const std::size_t address = text.find("): ");
  if (text.rfind("ERROR:", 0) == 0 && address != std::string::npos) text = text.substr(address + 3);
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  return oneLine(text);
}

}  // namespace boxprobe
