#!/usr/bin/python3
"""Transparency passes of VTK on the scenes that bench/oit wrote, without lighting, as there.

usage: BENCH_SCENES=FOLDER build/bench/oit TABLE.csv; xvfb-run -a /usr/bin/python3 vtk_transparency.py FOLDER TABLE.csv

Prints medians of whole frames and the largest error in 1/255 against the reference that bench/oit wrote beside each scene,
and adds rows to the table: vtk_peel and vtk_dual to the last layer, vtk_weighted is not exact. Says so and does nothing
where VTK (Debian's python3-vtk9) is missing."""
import array
import glob
import os
import statistics
import sys
import time

try:
    import vtk
except ImportError as missing:
    print(f"vtk: skipped: {missing}")
    sys.exit(0)


def numbers(file, kind, count):
    values = array.array(kind)
    values.fromfile(file, count)
    return values


def read_scene(path, renderer):
    """Size, perspective or not, objects; what VTK does not copy is returned to be kept."""
    kept = []
    with open(path, "rb") as file:
        size, perspective, objects = numbers(file, "I", 3)
        for _ in range(objects):
            vertices, faces = numbers(file, "I", 2)
            color = numbers(file, "f", 4)
            points, corners = numbers(file, "f", 3 * vertices), numbers(file, "I", 3 * faces)
            cells = array.array("q", [3]) * (4 * faces)
            for k in range(3):
                cells[k + 1 :: 4] = array.array("q", corners[k::3])
            coordinates, connections = vtk.vtkFloatArray(), vtk.vtkIdTypeArray()
            coordinates.SetNumberOfComponents(3)
            coordinates.SetVoidArray(points, len(points), 1)
            connections.SetVoidArray(cells, len(cells), 1)
            kept.append((points, cells))
            vtk_points, vtk_cells, mesh = vtk.vtkPoints(), vtk.vtkCellArray(), vtk.vtkPolyData()
            vtk_points.SetData(coordinates)
            vtk_cells.SetCells(faces, connections)
            mesh.SetPoints(vtk_points)
            mesh.SetPolys(vtk_cells)
            mapper, actor = vtk.vtkPolyDataMapper(), vtk.vtkActor()
            mapper.SetInputData(mesh)
            mapper.ScalarVisibilityOff()
            actor.SetMapper(mapper)
            actor.GetProperty().SetColor(*color[:3])
            actor.GetProperty().SetOpacity(color[3])
            actor.GetProperty().LightingOff()
            renderer.AddActor(actor)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(0, 0, 4)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetClippingRange(0.5, 8)
    camera.SetViewAngle(30.008)  # 2 atan 0.268
    if not perspective:
        camera.ParallelProjectionOn()
        camera.SetParallelScale(1)
    return size, kept


def passes(mode):
    sequence, collection, translucent = vtk.vtkSequencePass(), vtk.vtkRenderPassCollection(), vtk.vtkTranslucentPass()
    collection.AddItem(vtk.vtkLightsPass())
    collection.AddItem(vtk.vtkOpaquePass())
    layers = {
        "vtk_peel": vtk.vtkDepthPeelingPass,
        "vtk_dual": vtk.vtkDualDepthPeelingPass,
        "vtk_weighted": vtk.vtkOrderIndependentTranslucentPass,
    }[mode]()
    layers.SetTranslucentPass(translucent)
    if mode != "vtk_weighted":
        layers.SetMaximumNumberOfPeels(1000)
        layers.SetOcclusionRatio(0.0)
    collection.AddItem(layers)
    sequence.SetPasses(collection)
    camera_pass = vtk.vtkCameraPass()
    camera_pass.SetDelegatePass(sequence)
    return camera_pass


def worst_error(window, path, size):
    image = vtk.vtkUnsignedCharArray()
    window.GetRGBACharPixelData(0, 0, size - 1, size - 1, 0, image)
    picture, worst = memoryview(image), 0.0
    with open(path, "rb") as file:
        truth = numbers(file, "f", 4 * size * size)
    for at in range(0, 4 * size * size, 4):
        if truth[at + 3] == 0:  # not left out
            worst = max(worst, *(abs(picture[at + k] - 255 * truth[at + k]) for k in range(3)))
    return worst


def measure(path, mode, table):
    window, renderer = vtk.vtkRenderWindow(), vtk.vtkOpenGLRenderer()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetAlphaBitPlanes(1)
    renderer.SetBackground(1, 1, 1)
    window.AddRenderer(renderer)
    size, kept = read_scene(path, renderer)
    window.SetSize(size, size)
    renderer.SetPass(passes(mode))
    times = []
    while len(times) < 8 and sum(times[1:]) < 6000:  # the first makes programs
        start = time.perf_counter()
        window.Render()
        window.WaitForCompletion()
        times.append(1e3 * (time.perf_counter() - start))
    ms = statistics.median(times[1:])
    name, truth = os.path.basename(path)[:-6], path[:-6] + ".truth"
    error = worst_error(window, truth, size) if os.path.exists(truth) else -1.0
    print(f"{name:<18} {size:5}  {mode:<12} {ms:9.2f} ms  error {error:.2f}/255", flush=True)
    table.write(f"oit,{name},{size},{mode},{ms:.3f},0,{error:.3f}\n")
    window.Finalize()
    del kept


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    with open(sys.argv[2], "a") as table:
        for path in sorted(glob.glob(os.path.join(sys.argv[1], "*.scene"))):
            for mode in ("vtk_weighted", "vtk_dual", "vtk_peel"):
                measure(path, mode, table)


main()
