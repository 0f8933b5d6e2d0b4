"""A building as an OpenUSD stage, for Isaac Sim and other USD programs; needs the ``usd`` extra."""

import re
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from mansion_assets.catalogue import Catalogue
from mansion_assets.convex import Hull
from mansion_assets.mass_properties import FRICTION
from mansion_export.licences import licence_lines, licence_records
from mansion_export.meshes.building_model import building_models
from mansion_export.meshes.materials import linear
from mansion_export.meshes.model import Material, Mesh, Model, Node, Surface
from mansion_export.meshes.solids import Box
from mansion_export.physics.articulation import Assembly, Moving, assemblies, pose_at
from mansion_export.physics.collision import Colliders, Shape, mass_properties_of, shape_scaled
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.shapes import Size3

__all__ = ["building_usd", "usd_files"]


def building_usd(
    scenes: Sequence[FloorScene], catalogue: Catalogue | None = None, *, articulated: bool = False, site: bool = True
) -> bytes:
    """Make a USD stage of all floors, in the binary crate format (``.usdc``), z up, metres.

    Parameters
    ----------
    scenes : sequence of FloorScene
    catalogue : Catalogue, optional
        Where the assets are, when they are not all in the shipped one.
    articulated : bool
        Make doors, drawers and lids rigid bodies with joints (UsdPhysics), which stand as the scenes have them.

    Returns
    -------
    bytes
        Root prim ``/building`` > ``floor_2`` > one Xform for each element, whose ``mansion:id`` attribute is our id and
        which is an instance of a prototype where elements share a mesh. Materials are UsdPreviewSurface. Structure
        collides as triangle meshes, doors and objects as shapes of their own that are not drawn (UsdPhysics).

    Raises
    ------
    MansionError
        ``UNAVAILABLE`` where usd-core is not installed.
    """
    try:
        from pxr import Gf, Usd, UsdGeom, UsdPhysics
    except ImportError as error:
        raise MansionError(
            ErrorCode.UNAVAILABLE, "the USD export needs the package usd-core: pip install 'mansion_export[usd]'"
        ) from error
    stage = Usd.Stage.CreateInMemory()
    UsdGeom.SetStageUpAxis(stage, UsdGeom.Tokens.z)
    UsdGeom.SetStageMetersPerUnit(stage, 1.0)
    root = UsdGeom.Xform.Define(stage, "/building")
    stage.SetDefaultPrim(root.GetPrim())
    ordered = sorted(scenes, key=lambda scene: scene.floor)
    if ordered:
        root.GetPrim().SetDisplayName(ordered[0].building_id)
    records = licence_records(ordered, catalogue)
    stage.GetRootLayer().customLayerData = {
        "mansion": {"copyright": "; ".join(licence_lines(records)), "licences": {r["asset"]: r for r in records}}
    }
    writer = _Writer(stage)
    writer.friction(root.GetPrim())
    if articulated:
        UsdPhysics.Scene.Define(stage, "/building/physics").CreateGravityDirectionAttr(Gf.Vec3f(0.0, 0.0, -1.0))
    for model, scene in zip(building_models(ordered, site=site, catalogue=catalogue), ordered):
        moving = assemblies(scene, {node.id: node for node in model.nodes}, catalogue) if articulated else {}
        writer.floor(model, Colliders(scene, catalogue), moving)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "building.usdc"
        stage.GetRootLayer().Export(str(path))
        return path.read_bytes()


def usd_files(scenes: Sequence[FloorScene], *, articulated: bool = False, site: bool = True) -> dict[str, bytes]:
    """Return ``building.usdc`` by its path in the building's folder."""
    return {"building.usdc": building_usd(scenes, articulated=articulated, site=site)}


class _Writer:
    """Writes prototypes, materials and instances on a stage."""

    def __init__(self, stage: Any) -> None:
        self.stage = stage
        self.prototypes: dict[tuple[str, bool], str] = {}
        self.materials: dict[Material, Any] = {}
        from pxr import Sdf

        holder = stage.CreateClassPrim("/prototypes")
        self.prototype_root = str(holder.GetPath())
        self.token = Sdf.ValueTypeNames.String

    def friction(self, root: Any) -> None:
        """Bind everything below the root to one physics material."""
        from pxr import UsdPhysics, UsdShade

        made = UsdShade.Material.Define(self.stage, "/building/materials/physics")
        physics = UsdPhysics.MaterialAPI.Apply(made.GetPrim())
        physics.CreateStaticFrictionAttr(FRICTION)
        physics.CreateDynamicFrictionAttr(FRICTION)
        binding = UsdShade.MaterialBindingAPI.Apply(root)
        binding.Bind(made, UsdShade.Tokens.weakerThanDescendants, "physics")

    def floor(self, model: Model, colliders: Colliders, moving: Mapping[str, Assembly]) -> None:
        from pxr import Gf, UsdGeom

        path = f"/building/{_identifier(model.name)}"
        xform = UsdGeom.Xform.Define(self.stage, path)
        xform.AddTranslateOp().Set(Gf.Vec3d(0.0, 0.0, model.elevation))
        taken: dict[str, int] = {}
        for node in model.nodes:
            mesh = model.meshes[node.mesh]
            if mesh.surfaces:
                name = _identifier(node.id)
                taken[name] = taken.get(name, 0) + 1
                suffix = f"_{taken[name]}" if taken[name] > 1 else ""
                if node.id in moving:
                    self.assembly(f"{path}/{name}{suffix}", moving[node.id])
                else:
                    self.node(f"{path}/{name}{suffix}", node, mesh, colliders.of(node, mesh))

    def node(self, path: str, node: Node, mesh: Mesh, shapes: Sequence[Shape] | None) -> None:
        """Write an instance of a mesh."""
        self.instance(self.place(path, node), mesh, shapes, node.scale)

    def place(self, path: str, node: Node) -> Any:
        """Write the frame of an element, named after it."""
        from pxr import Gf, UsdGeom

        xform = UsdGeom.Xform.Define(self.stage, path)
        xform.GetPrim().SetDisplayName(node.id)
        self.identify(xform, node.id)
        if any(node.position):
            xform.AddTranslateOp().Set(Gf.Vec3d(*(float(value) for value in node.position)))
        if node.rotation % 360.0:
            xform.AddRotateZOp().Set(float(node.rotation))
        return xform

    def identify(self, xform: Any, name: str) -> None:
        """Write our id on a prim."""
        xform.GetPrim().CreateAttribute("mansion:id", self.token, custom=True).Set(name)

    def instance(self, xform: Any, mesh: Mesh, shapes: Sequence[Shape] | None, scale: Size3) -> None:
        """Make a prim an instance of a mesh's prototype."""
        from pxr import Gf

        prim = xform.GetPrim()
        prim.GetReferences().AddInternalReference(self.prototype(mesh, shapes))
        prim.SetInstanceable(True)
        if scale != (1.0, 1.0, 1.0):
            xform.AddScaleOp().Set(Gf.Vec3f(*(float(value) for value in scale)))

    def assembly(self, path: str, assembly: Assembly) -> None:
        """Write an element with parts on joints."""
        from pxr import UsdGeom

        node = assembly.node
        frame = self.place(path, node)
        if assembly.mesh is not None:
            still = UsdGeom.Xform.Define(self.stage, f"{path}/body")
            self.instance(still, assembly.mesh, assembly.shapes, node.scale)
        for part in assembly.moving:
            self.moving(path, part, node.scale)
            self.joint(path, frame, part)

    def moving(self, path: str, part: Moving, scale: Size3) -> None:
        """Write a part that moves as a rigid body, where the scene has it."""
        from pxr import Gf, UsdGeom, UsdPhysics

        shift, turn = pose_at(part.joint, part.position)
        xform = UsdGeom.Xform.Define(self.stage, f"{path}/{part.joint.part}")
        self.identify(xform, part.id)
        xform.AddTranslateOp().Set(Gf.Vec3d(*shift))
        xform.AddRotateXYZOp().Set(Gf.Vec3f(*turn))
        geometry = UsdGeom.Xform.Define(self.stage, f"{path}/{part.joint.part}/geometry")
        self.instance(geometry, part.mesh, part.shapes, scale)
        UsdPhysics.RigidBodyAPI.Apply(xform.GetPrim())
        body = mass_properties_of([shape_scaled(shape, scale) for shape in part.shapes], part.mass)
        moments, axes = np.linalg.eigh(body.inertia)
        if np.linalg.det(axes) < 0.0:
            axes[:, 0] = -axes[:, 0]
        turned = Gf.Matrix3d(*axes.T.ravel().tolist()).ExtractRotation().GetQuat()
        mass = UsdPhysics.MassAPI.Apply(xform.GetPrim())
        mass.CreateMassAttr(body.mass)
        mass.CreateCenterOfMassAttr(Gf.Vec3f(*body.center))
        mass.CreateDiagonalInertiaAttr(Gf.Vec3f(*moments.tolist()))
        mass.CreatePrincipalAxesAttr(Gf.Quatf(turned))

    def joint(self, path: str, frame: Any, part: Moving) -> None:
        """Write the joint of a part against its element's frame, with limits and a damper."""
        from pxr import Gf, UsdPhysics

        joint = part.joint
        turns = joint.kind == "hinge"
        kind = UsdPhysics.RevoluteJoint if turns else UsdPhysics.PrismaticJoint
        made = kind.Define(self.stage, f"{path}/{joint.part}_joint")
        along = max(range(3), key=lambda k: abs(joint.axis[k]))
        made.CreateAxisAttr("XYZ"[along])
        forward = joint.axis[along] > 0.0
        made.CreateLowerLimitAttr(0.0 if forward else -joint.travel)
        made.CreateUpperLimitAttr(joint.travel if forward else 0.0)
        made.CreateBody0Rel().SetTargets([frame.GetPath()])
        made.CreateBody1Rel().SetTargets([f"{path}/{joint.part}"])
        for attribute in (made.CreateLocalPos0Attr, made.CreateLocalPos1Attr):
            attribute(Gf.Vec3f(*joint.origin))
        for attribute in (made.CreateLocalRot0Attr, made.CreateLocalRot1Attr):
            attribute(Gf.Quatf(1.0))
        drive = UsdPhysics.DriveAPI.Apply(made.GetPrim(), "angular" if turns else "linear")
        drive.CreateTypeAttr("force")
        # UsdPhysics counts angles in degrees.
        drive.CreateDampingAttr(part.damping * (np.pi / 180.0 if turns else 1.0))

    def prototype(self, mesh: Mesh, shapes: Sequence[Shape] | None) -> str:
        """Return the path of a mesh's prototype, writing it when it is new; without `shapes` the mesh collides."""
        from pxr import UsdGeom, UsdPhysics

        key = (mesh.name, shapes is not None and not shapes)
        if key in self.prototypes:
            return self.prototypes[key]
        path = f"{self.prototype_root}/{_identifier(mesh.name)}_{len(self.prototypes)}"
        self.prototypes[key] = path
        UsdGeom.Xform.Define(self.stage, path)
        for i, surface in enumerate(mesh.surfaces):
            prim = self.surface(f"{path}/part_{i}", surface)
            if shapes is None:
                UsdPhysics.CollisionAPI.Apply(prim)
                UsdPhysics.MeshCollisionAPI.Apply(prim).CreateApproximationAttr(UsdPhysics.Tokens.none)
        for i, shape in enumerate(shapes or ()):
            if isinstance(shape, Hull):
                self.hull(f"{path}/collision_{i}", shape)
            else:
                self.box(f"{path}/collision_{i}", shape)
        return path

    def surface(self, path: str, surface: Surface) -> Any:
        """Write triangles with their material, and return their prim."""
        from pxr import UsdShade

        prim = self.triangles(path, surface).GetPrim()
        UsdShade.MaterialBindingAPI.Apply(prim).Bind(self.material(surface.material))
        return prim

    def triangles(self, path: str, surface: Surface | Hull) -> Any:
        """Write triangles as a mesh."""
        from pxr import UsdGeom, Vt

        shape = UsdGeom.Mesh.Define(self.stage, path)
        points = np.ascontiguousarray(surface.vertices, dtype=np.float32)
        faces = np.ascontiguousarray(surface.faces.reshape(-1), dtype=np.int32)
        shape.CreatePointsAttr(Vt.Vec3fArray.FromNumpy(points))
        shape.CreateFaceVertexIndicesAttr(Vt.IntArray.FromNumpy(faces))
        counts = np.full(len(surface.faces), 3, dtype=np.int32)
        shape.CreateFaceVertexCountsAttr(Vt.IntArray.FromNumpy(counts))
        shape.CreateSubdivisionSchemeAttr(UsdGeom.Tokens.none)
        shape.CreateExtentAttr(Vt.Vec3fArray.FromNumpy(np.stack([points.min(0), points.max(0)])))
        return shape

    def hull(self, path: str, hull: Hull) -> None:
        """Write a convex mesh that collides and is not drawn."""
        from pxr import UsdGeom, UsdPhysics

        shape = self.triangles(path, hull)
        shape.CreatePurposeAttr(UsdGeom.Tokens.guide)
        prim = shape.GetPrim()
        UsdPhysics.CollisionAPI.Apply(prim)
        UsdPhysics.MeshCollisionAPI.Apply(prim).CreateApproximationAttr(UsdPhysics.Tokens.convexHull)

    def box(self, path: str, box: Box) -> None:
        """Write a box that collides and is not drawn."""
        from pxr import Gf, UsdGeom, UsdPhysics

        cube = UsdGeom.Cube.Define(self.stage, path)
        cube.CreateSizeAttr(1.0)
        cube.CreatePurposeAttr(UsdGeom.Tokens.guide)
        cube.AddTranslateOp().Set(Gf.Vec3d(*box.center))
        cube.AddScaleOp().Set(Gf.Vec3f(*box.size))
        cube.CreateExtentAttr([(-0.5, -0.5, -0.5), (0.5, 0.5, 0.5)])
        UsdPhysics.CollisionAPI.Apply(cube.GetPrim())

    def material(self, material: Material) -> Any:
        """Return a material, writing it when it is new."""
        from pxr import Gf, Sdf, UsdShade

        if material not in self.materials:
            path = f"/building/materials/{_identifier(material.name)}_{len(self.materials)}"
            made = UsdShade.Material.Define(self.stage, path)
            shader = UsdShade.Shader.Define(self.stage, f"{path}/surface")
            shader.CreateIdAttr("UsdPreviewSurface")
            color = Gf.Vec3f(*linear(material.color))
            shader.CreateInput("diffuseColor", Sdf.ValueTypeNames.Color3f).Set(color)
            numbers = {"roughness": material.roughness, "metallic": material.metallic, "opacity": material.alpha}
            for name, value in numbers.items():
                shader.CreateInput(name, Sdf.ValueTypeNames.Float).Set(float(value))
            if material.emission > 0.0:
                shader.CreateInput("emissiveColor", Sdf.ValueTypeNames.Color3f).Set(color * material.emission)
            made.CreateSurfaceOutput().ConnectToSource(shader.ConnectableAPI(), "surface")
            self.materials[material] = made
        return self.materials[material]


def _identifier(text: str) -> str:
    """Return a valid prim name for an id."""
    name = re.sub(r"[^A-Za-z0-9_]", "_", text)
    return name if name[:1].isalpha() or name[:1] == "_" else f"_{name}"
