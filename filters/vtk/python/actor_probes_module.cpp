// ActorProbes as a Python extension, the basis of boxprobe/__init__.py, which checks argument types and contains the
// documentation. Objects of VTK's Python modules are unwrapped; fields are passed as JSON with the keys of scene files,
// so that names, ranges and messages are those of a scene. InputError becomes a ValueError, any other failure a
// RuntimeError.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <vtkActor.h>
#include <vtkPythonUtil.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "filters/core/base/errors.h"
#include "filters/io/cube/cube_file.h"
#include "filters/io/scene/scene_json.h"
#include "filters/vtk/actors/actor_probes.h"

namespace {

namespace py = pybind11;
using namespace boxprobe;

/// The VTK object of class `className` in `wrapped`. Never null.
template <typename T>
T* unwrapped(const py::object& wrapped, const char* className) {
  vtkObjectBase* object = wrapped.is_none() ? nullptr : vtkPythonUtil::GetPointerFromObject(wrapped.ptr(), className);
  if (PyErr_Occurred() != nullptr) PyErr_Clear();
  T* found = T::SafeDownCast(object);
  if (found == nullptr) throw py::type_error(std::string("not a ") + className);
  return found;
}

/// A scene with these `probes` and every key present, so that keys can be replaced.
Json completeScene(std::vector<Probe> probes) {
  Scene scene;
  scene.probes = std::move(probes);
  return sceneToJson(scene, "", JsonForm::Complete);
}

/// Parses a scene as if its file were in the current folder.
Scene readScene(const Json& root) {
  Scene scene = sceneFromJson(root, std::filesystem::current_path().string());
  validate(scene);
  return scene;
}

class PythonProbes {
 public:
  explicit PythonProbes(const py::object& renderer) : probes_(unwrapped<vtkRenderer>(renderer, "vtkRenderer")) {}

  void addProbe(const std::string& name, const std::string& fields) {
    Probe probe;
    probe.name = name;
    probes_.addProbe(changed(probe, fields));
  }
  void setProbe(const std::string& name, const std::string& fields) {
    const std::size_t index = indexOf(name);
    probes_.setProbe(index, changed(probes_.probes()[index], fields));
  }
  std::string probe(const std::string& name) const {
    return completeScene({probes_.probes()[indexOf(name)]})["probes"][0].dump();
  }
  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const Probe& probe : probes_.probes()) names.push_back(probe.name);
    return names;
  }

  void addActor(const py::object& actor, bool seenByProbes) {
    probes_.addActor(unwrapped<vtkActor>(actor, "vtkActor"), seenByProbes);
  }
  void removeActor(const py::object& actor) { probes_.removeActor(unwrapped<vtkActor>(actor, "vtkActor")); }
  void removeAllActors() { probes_.removeAllActors(); }

  void setSky(const std::string& fields) {
    Json root = completeScene({});
    root["sky"] = parseJsonText(fields, "fields").root;
    const Scene scene = readScene(root);
    probes_.setSky(scene.sky, scene.skyRotationDegrees);
  }
  void setExposure(double exposure) {
    Json root = completeScene({});
    root["exposure"] = exposure;
    probes_.setExposure(readScene(root).exposure);
  }
  void setEnergy(const std::string& energy) {
    Json root = completeScene({});
    root["energy"] = energy;
    probes_.setEnergy(readScene(root).energy);
  }
  void setEmission(bool shown) { probes_.setEmission(shown); }

  bool capture() { return probes_.capture(); }
  void setMaps(const std::string& name, const std::string& file) {
    const std::size_t index = indexOf(name);
    probes_.setMaps(index, loadBakedProbe(file).maps);
  }
  std::string error() const { return probes_.error(); }
  void clearError() { probes_.clearError(); }
  std::vector<std::string> remarks() const { return probes_.remarks(); }
  void releaseGraphics() { probes_.releaseGraphics(); }

 private:
  std::size_t indexOf(const std::string& name) const {
    const std::vector<std::string> all = names();
    const auto at = std::find(all.begin(), all.end(), name);
    if (at == all.end()) {
      std::string text = "there is no probe \"" + name + "\"; there are: ";
      for (const std::string& one : all) text += (&one == &all.front() ? "" : ", ") + one;
      throw InputError(all.empty() ? "there is no probe \"" + name + "\"; add_probe() adds one" : text);
    }
    return static_cast<std::size_t>(at - all.begin());
  }
  static Probe changed(const Probe& probe, const std::string& fields) {
    Json root = completeScene({probe});
    const Json given = parseJsonText(fields, "fields").root;
    for (const auto& [key, value] : given.items()) {
      // None means an absent key: a probe without a separate influence box, without a bevel.
      if (value.is_null()) {
        root["probes"][0].erase(key);
      } else {
        root["probes"][0][key] = value;
      }
    }
    return readScene(root).probes.front();
  }

  ActorProbes probes_;
};

}  // namespace

PYBIND11_MODULE(_actor_probes, module) {
  py::register_local_exception_translator([](std::exception_ptr failure) {
    try {
      if (failure) std::rethrow_exception(failure);
    } catch (const InputError& error) {
      PyErr_SetString(PyExc_ValueError, error.what());
    } catch (const Error& error) {
      PyErr_SetString(PyExc_RuntimeError, error.what());
    }
  });
  py::class_<PythonProbes>(module, "Probes")
      .def(py::init<py::object>())
      .def("add_probe", &PythonProbes::addProbe)
      .def("set_probe", &PythonProbes::setProbe)
      .def("probe", &PythonProbes::probe)
      .def("names", &PythonProbes::names)
      .def("add_actor", &PythonProbes::addActor)
      .def("remove_actor", &PythonProbes::removeActor)
      .def("remove_all_actors", &PythonProbes::removeAllActors)
      .def("set_sky", &PythonProbes::setSky)
      .def("set_exposure", &PythonProbes::setExposure)
      .def("set_energy", &PythonProbes::setEnergy)
      .def("set_emission", &PythonProbes::setEmission)
      .def("capture", &PythonProbes::capture)
      .def("set_maps", &PythonProbes::setMaps)
      .def("error", &PythonProbes::error)
      .def("clear_error", &PythonProbes::clearError)
      .def("remarks", &PythonProbes::remarks)
      .def("release_graphics", &PythonProbes::releaseGraphics);
}
