/**
 * @class   vtkParetoLabels
 * @brief   names beside the points of a chart, none over another
 *
 * Must be painted after its chart, whose axes give the screen positions of points. Each name is placed at the nearest
 * free position around its point; a leader line connects distant ones.
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
