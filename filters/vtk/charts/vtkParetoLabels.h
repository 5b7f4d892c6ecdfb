/**
 * @class   vtkParetoLabels
 * @brief   names beside the points of a chart, none over another
 *
 * Painted after its chart, whose axes say where a point lies on the screen. Each name goes to the nearest of some
 * places around its point that is free; where that is not beside the point, a line leads to it.
 */
#pragma once

#include <vtkContextItem.h>
#include <vtkWeakPointer.h>

#include <string>
#include <vector>

class vtkChartXY;

class vtkParetoLabels : public vtkContextItem {
 public:
  static vtkParetoLabels* New();
  vtkTypeMacro(vtkParetoLabels, vtkContextItem)

      /// Without a text: a position to keep clear.
      struct Label {
    double X = 0.0, Y = 0.0;  ///< in the chart's units
    std::string Text = {};
    bool Important = false;  ///< placed before others, and bold
  };
  void SetChart(vtkChartXY* chart);
  void SetLabels(std::vector<Label> labels);

  bool Paint(vtkContext2D* painter) override;

 protected:
  vtkParetoLabels() = default;
  ~vtkParetoLabels() override = default;

 private:
  vtkParetoLabels(const vtkParetoLabels&) = delete;
  void operator=(const vtkParetoLabels&) = delete;

  vtkWeakPointer<vtkChartXY> Chart;
  std::vector<Label> Labels;
};
