#!/usr/bin/python3
"""Silhouettes and feature edges by VTK, on the meshes that bench/silhouette wrote.

usage: BENCH_MESHES=FOLDER build/bench/silhouette TABLE.csv; vtk_feature_lines.py FOLDER TABLE.csv

Prints medians over views of an eye that turns by one degree a view, as there, and adds rows to the table: extract by
vtkPolyDataSilhouette (perspective), feature_edges by vtkFeatureEdges (boundary, non-manifold and feature edges; no view).
Says so and does nothing where VTK (Debian's python3-vtk9) is missing."""
import array
import glob
import math
import os
import statistics
import sys
import time

try:
    import vtk
except ImportError as missing:
    print(f"vtk: skipped: {missing}")
    sys.exit(0)


def read_mesh(path):
    """Points and triangles of one file: two 64-bit counts, floats, 32-bit indices."""
    counts, points, corners = array.array("Q"), array.array("f"), array.array("I")
    with open(path, "rb") as file:
        counts.fromfile(file, 2)
        points.fromfile(file, 3 * counts[0])
        corners.fromfile(file, 3 * counts[1])
    faces = int(counts[1])
    cells = array.array("q", [3]) * (4 * faces)  # 3, a, b, c of each
    for k in range(3):
        cells[k + 1 :: 4] = array.array("q", corners[k::3])
    coordinates, connections = vtk.vtkFloatArray(), vtk.vtkIdTypeArray()
    coordinates.SetNumberOfComponents(3)
    coordinates.SetVoidArray(points, len(points), 1)
    connections.SetVoidArray(cells, len(cells), 1)
    vtk_points = vtk.vtkPoints()
    vtk_points.SetData(coordinates)
    vtk_cells = vtk.vtkCellArray()
    vtk_cells.SetCells(faces, connections)
    mesh = vtk.vtkPolyData()
    mesh.SetPoints(vtk_points)
    mesh.SetPolys(vtk_cells)
    return mesh, 3 * faces // 2, (points, cells)  # which VTK does not copy


def eye_number(i):
    """The path of view_number in bench/silhouette.c."""
    angle = 0.37 + math.radians(i)
    radius = 3.5 + 1.5 * math.sin(1.47 * angle)
    return radius * math.cos(angle), radius * math.sin(angle), radius * 0.5 * math.sin(0.3 * angle)


def median_ms(run, count):
    times = []
    for i in range(count):
        start = time.perf_counter()
        lines = run(i)
        times.append(1e3 * (time.perf_counter() - start))
    return statistics.median(times), lines


def silhouettes(mesh):
    camera = vtk.vtkCamera()
    find = vtk.vtkPolyDataSilhouette()
    find.SetInputData(mesh)
    find.SetCamera(camera)
    find.SetEnableFeatureAngle(0)
    find.BorderEdgesOff()

    def view(i):
        camera.SetPosition(*eye_number(i))
        find.Modified()
        find.Update()
        return find.GetOutput().GetNumberOfLines()

    view(0)  # builds its edges
    return median_ms(view, 15)


def feature_edges(mesh):
    def run(_):
        find = vtk.vtkFeatureEdges()
        find.SetInputData(mesh)
        find.SetFeatureAngle(30)
        find.Update()
        return find.GetOutput().GetNumberOfLines()

    return median_ms(run, 5)


def main(folder, table):
    with open(table, "a", encoding="ascii") as csv:
        for path in sorted(glob.glob(os.path.join(folder, "*.mesh"))):
            scene = os.path.basename(path).rsplit("_", 1)[0]
            mesh, edges, _kept = read_mesh(path)
            for work, run in (("extract", silhouettes), ("feature_edges", feature_edges)):
                ms, lines = run(mesh)
                print(f"{work:14} {scene:14} {edges:9}  vtk {ms:10.3f} ms {1e6 * ms / edges:8.1f} ns/edge  {lines} lines",
                      flush=True)
                csv.write(f"{work},{scene},{edges},vtk,{ms:.6f},0,0\n")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
