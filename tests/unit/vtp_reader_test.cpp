// VTP files in every form that VTK writes, and damaged ones.
#include "filters/vtk/import/vtp_reader.h"

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "filters/io/files/read_budget.h"
#include "filters/vtk/import/model_reader.h"
#include "tests/unit/error_text.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

class VtpReader : public TemporaryFolder {
 protected:
  /// A grid of squares and a strip, with everything that is read; large enough for several blocks.
  static void fill(vtkPolyData* data, int side) {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkFloatArray> normals, uv;
    normals->SetName("normals of it");
    normals->SetNumberOfComponents(3);
    uv->SetName("uv");
    uv->SetNumberOfComponents(2);
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetName("colours");
    colors->SetNumberOfComponents(3);
    vtkNew<vtkCellArray> squares, strips;
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        points->InsertNextPoint(x, y, std::sin(0.1 * x * y));
        normals->InsertNextTuple3(0, 0, 1);
        uv->InsertNextTuple2(x / 100.0, y / 100.0);
        colors->InsertNextTuple3(x % 256, y % 256, 255);
        if (x + 1 == side || y + 1 == side) continue;
        const vtkIdType at = y * side + x;
        const vtkIdType corners[4] = {at, at + 1, at + side + 1, at + side};
        squares->InsertNextCell(4, corners);
      }
    }
    const vtkIdType strip[4] = {0, 1, side, side + 1};
    strips->InsertNextCell(4, strip);
    data->SetPoints(points);
    data->SetPolys(squares);
    data->SetStrips(strips);
    data->GetPointData()->SetNormals(normals);
    data->GetPointData()->SetTCoords(uv);
    data->GetPointData()->AddArray(colors);
  }

  /// With its arrays behind the XML, as they are.
  std::string appended(vtkPolyData* data) const {
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetInputData(data);
    writer->SetFileName(file("w.vtp").c_str());
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOff();
    EXPECT_EQ(writer->Write(), 1);
    return read("w.vtp");
  }

  /// Its one piece so many times.
  static std::string withPieces(const std::string& whole, int count) {
    const std::string close = "</Piece>";
    const std::size_t begin = whole.find("<Piece"), end = whole.find(close) + close.size();
    std::string text = whole.substr(0, begin);
    for (int i = 0; i < count; ++i) text += whole.substr(begin, end - begin);
    return text + whole.substr(end);
  }

  std::string refusal(const std::string& bytes) const {
    const std::string path = write("m.vtp", bytes);
    return errorText([&] { readModel(path); });
  }
};

TEST_F(VtpReader, EveryFormThatVtkWritesIsTheSameMesh) {
  vtkNew<vtkPolyData> data;
  const int side = 60;
  fill(data, side);
  std::vector<Mesh> meshes;
  for (const int mode : {vtkXMLWriter::Ascii, vtkXMLWriter::Binary, vtkXMLWriter::Appended}) {
    for (const int compressor : {vtkXMLWriter::NONE, vtkXMLWriter::ZLIB, vtkXMLWriter::LZ4, vtkXMLWriter::LZMA}) {
      for (const bool wide : {false, true}) {
        for (const bool encoded : {false, true}) {
          for (const bool big : {false, true}) {
            vtkNew<vtkXMLPolyDataWriter> writer;
            writer->SetInputData(data);
            writer->SetFileName(file("m.vtp").c_str());
            writer->SetDataMode(mode);
            writer->SetCompressorType(compressor);
            if (compressor != vtkXMLWriter::NONE) writer->SetBlockSize(4096);
            wide ? writer->SetHeaderTypeToUInt64() : writer->SetHeaderTypeToUInt32();
            writer->SetEncodeAppendedData(encoded);
            big ? writer->SetByteOrderToBigEndian() : writer->SetByteOrderToLittleEndian();
            ASSERT_EQ(writer->Write(), 1);
            SCOPED_TRACE(std::to_string(mode) + " " + std::to_string(compressor) + (wide ? " wide" : "") +
                         (encoded ? " encoded" : "") + (big ? " big" : ""));
            meshes.push_back(readVtp(file("m.vtp")).meshes.at(0));
            const Mesh& mesh = meshes.back();
            ASSERT_EQ(mesh.positions.size(), std::size_t(side * side));
            ASSERT_EQ(mesh.indices.size(), std::size_t(6 * (side - 1) * (side - 1) + 6));
            EXPECT_EQ(mesh.positions, meshes.front().positions);
            EXPECT_EQ(mesh.indices, meshes.front().indices);
            EXPECT_EQ(mesh.normals[7], glm::vec3(0, 0, 1));
            EXPECT_NEAR(mesh.uv[7].x, 0.07f, 1e-6f);
            EXPECT_NEAR(mesh.uv[7].y, 1.0f, 1e-6f);
            EXPECT_EQ(mesh.colors[7].b, 1.0f);
          }
        }
      }
    }
  }
  EXPECT_EQ(meshes.front().positions[61], glm::vec3(1.0, 1.0, std::sin(0.1)));
}

TEST_F(VtpReader, DamageIsSaidAndCostsNothing) {
  vtkNew<vtkPolyData> data;
  fill(data, 20);
  const std::string whole = appended(data);
  std::size_t refused = 0;
  constexpr std::size_t kTries = 300;
  for (std::size_t i = 0; i < kTries; ++i) {
    std::string bytes = whole;
    bytes[(7919 * i) % bytes.size()] = static_cast<char>(37 * i);
    try {
      readModel(write("m.vtp", bytes));
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, kTries / 4);
  for (std::size_t length = 0; length + 60 < whole.size(); length += 97)
    EXPECT_NE(refusal(whole.substr(0, length)), "");
}

TEST_F(VtpReader, PiecesThatShareTheirBytesCountEachTime) {
  vtkNew<vtkPolyData> data;
  fill(data, 60);
  const std::string whole = appended(data);
  const std::uint64_t usual = std::exchange(readBudgetBytes(), 4 << 20);
  EXPECT_EQ(readModel(write("m.vtp", withPieces(whole, 1))).meshes.size(), 1u);
  const std::string problem = refusal(withPieces(whole, 300));
  readBudgetBytes() = usual;
  EXPECT_NE(problem.find("comes, with all before it, to more than"), std::string::npos) << problem;
  EXPECT_EQ(readModel(write("m.vtp", withPieces(whole, 300))).meshes.size(), 1u);
}

/// What pieces before had is not counted again for each.
TEST_F(VtpReader, ManyPiecesWithColoursOfCellsAreRead) {
  vtkNew<vtkPolyData> data;
  fill(data, 4);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("of cells");
  colors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
    colors->InsertNextTuple3(10.0 * static_cast<double>(i), 7, 3);
  data->GetCellData()->SetScalars(colors);
  const std::string pieces = withPieces(appended(data), 1000);
  const std::uint64_t usual = std::exchange(readBudgetBytes(), 4 << 20);
  EXPECT_EQ(readModel(write("m.vtp", pieces)).meshes.size(), 1u);
  readBudgetBytes() = usual;
}

TEST_F(VtpReader, WhatIsMadeOfNumbersCountsToo) {
  constexpr vtkIdType kCorners = 200000;
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  for (const double x : {0.0, 1.0, 3.0}) points->InsertNextPoint(x, x * x, 0.0);
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell(static_cast<int>(kCorners));
  for (vtkIdType i = 0; i < kCorners; ++i) strips->InsertCellPoint(i % 3);
  data->SetPoints(points);
  data->SetStrips(strips);
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->SetFileName(file("w.vtp").c_str());
  ASSERT_EQ(writer->Write(), 1);
  const std::string strip = read("w.vtp");
  ASSERT_LT(strip.size(), 30000u);
  const std::uint64_t usual = std::exchange(readBudgetBytes(), 4 << 20);  // the indices alone are 3.2 MB
  const std::string made = refusal(strip);
  readBudgetBytes() = 10 << 20;  // with three corners each: 8.8 MB
  const std::string meshes = refusal(strip);
  readBudgetBytes() = usual;
  EXPECT_NE(made.find("Strips: comes, with all before it"), std::string::npos) << made;
  EXPECT_NE(meshes.find("PolyData: comes, with all before it"), std::string::npos) << meshes;
}

TEST_F(VtpReader, HeadersArePromisesThatAreHeld) {
  const auto vtp = [](const std::string& array) {
    return "<VTKFile type=\"PolyData\" header_type=\"UInt32\" compressor=\"vtkZLibDataCompressor\"><PolyData><Piece "
           "NumberOfPoints=\"3\" NumberOfPolys=\"1\"><Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" "
           "format=\"" +
           array + "</DataArray></Points></Piece></PolyData></VTKFile>";
  };
  // 2^32 - 1 blocks of 2^31 bytes.
  EXPECT_NE(refusal(vtp("binary\">/////wAAAIAAAACA")).find("damaged header"), std::string::npos);
  EXPECT_NE(refusal(vtp("binary\">AQAAAAAAAIAAAAAA")).find("header"), std::string::npos);
  EXPECT_NE(refusal(vtp("ascii\">0 0 0 1 0 0 0 1")).find("9 values are needed"), std::string::npos);
  EXPECT_NE(refusal(vtp("ascii\">0 0 0 1 0 0 0 1 x")).find("not a number"), std::string::npos);
  EXPECT_NE(refusal(vtp("appended\" offset=\"900\">")).find("behind the end"), std::string::npos);
  EXPECT_NE(refusal("<!DOCTYPE a [<!ENTITY b \"bbbb\">]><VTKFile type=\"Polydata\">&b;").find("PolyData"),
            std::string::npos);
}

}  // namespace
}  // namespace boxprobe
