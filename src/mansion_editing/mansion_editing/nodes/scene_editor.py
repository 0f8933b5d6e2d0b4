"""``scene_editor``: the one writer of scenes; the editing tools and the editing agent as services."""

import re
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from datetime import UTC, datetime
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import Any

from rcl_interfaces.msg import ParameterDescriptor, SetParametersResult
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.parameter import Parameter

from mansion_assets.library.building_assets import catalogue_for
from mansion_assets.retrieval.configured import configured_retriever
from mansion_editing.derived_files import DerivedFiles
from mansion_editing.editor import TOOLS, OpenEditors, SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.physics.engine import engine_named
from mansion_editing.provisioning.provision import provision
from mansion_editing.storage import BuildingStore
from mansion_msgs_py.editing.instructions import AgentReport, InstructArgs, ProvisionArgs
from mansion_msgs_py.editing.open_buildings import CanceledEdits, CancelEdit, EditorInfo, OpenEditorArgs
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.interfaces import service, topic
from mansion_msgs_py.nodes.allowed_folders import declare_allowed_folders
from mansion_msgs_py.nodes.node import MansionNode
from mansion_msgs_py.nodes.run import run_node
from mansion_msgs_py.nodes.shell import JsonPublisher, add_json_service
from mansion_msgs_py.running_calls import RunningCalls
from mansion_scene.refurnishing import furnish_room

__all__ = ["SceneEditorNode", "main"]

_PARAMETERS = (
    ("hooks", "mansion_bringup.edit_hooks", "module that checks edits and writes derived files"),
    ("physics", "mujoco", "engine that settles placed objects: mujoco, static or thor"),
    ("building", "", "folder to open at the start"),
)
_READ_ONCE = ("hooks", "building")


class SceneEditorNode(MansionNode):
    """Serves ``scene/...`` and publishes each floor that an edit changed."""

    def __init__(self) -> None:
        super().__init__("scene_editor")
        for name, value, text in _PARAMETERS:
            descriptor = ParameterDescriptor(description=text, read_only=name in _READ_ONCE)
            self.declare_parameter(name, value, descriptor)
        engine_named(self._physics())
        self.add_on_set_parameters_callback(_accept_physics)
        self._allowed = declare_allowed_folders(self, str(self.get_parameter("building").value))
        self._editors = OpenEditors()
        self._edits = RunningCalls[str]("edits")
        self._scenes = JsonPublisher(self, topic("floor_scene"))
        hooks = str(self.get_parameter("hooks").value)
        self._hooks = _load_hooks(hooks)
        self._derived = DerivedFiles(hooks, self._allowed, self._tell_written, self._tell_behind)
        group = MutuallyExclusiveCallbackGroup()
        add_json_service(self, service("scene/open"), self.open, callback_group=group)
        add_json_service(self, service("scene/instruct"), self.instruct, callback_group=group)
        add_json_service(self, service("scene/provision"), self.provision, callback_group=group)
        add_json_service(self, service("scene/cancel"), self.cancel, callback_group=ReentrantCallbackGroup())
        for tool in TOOLS:
            name = f"scene/{_snake(tool)}"
            add_json_service(self, service(name), self._tool(tool), callback_group=group)
        if folder := str(self.get_parameter("building").value):
            self.open(OpenEditorArgs(path=folder))

    def open(self, args: OpenEditorArgs) -> EditorInfo:
        """Open a building under a name."""
        validator = getattr(self._hooks, "new_faults", None)
        records = getattr(self._hooks, "records", None)
        store = BuildingStore(Path(args.path), validator=validator, records=records, clock=_time, allowed=self._allowed)
        editor = SceneEditor(
            store,
            catalogue_for(store.folder, remembered=store.building.request.libraries),
            engine_named(self._physics()),
            who=args.who or args.editor or "scene_editor",
            autosave=args.autosave,
            retriever=configured_retriever(),
            furnisher=furnish_room,
        )
        self._editors.put(args.editor, editor)
        self._finish(store)
        entries = store.building.floors
        return EditorInfo(
            building_id=store.building.building_id,
            floors=[entry.floor for entry in entries],
            labels=[entry.label for entry in entries],
            revisions={str(f): scene.revision for f, scene in editor.state.scenes.items()},
            editor=args.editor,
            who=editor.who,
            autosave=args.autosave,
        )

    def instruct(self, args: InstructArgs) -> AgentReport:
        """Carry out an instruction."""
        with self._edited(args.editor) as editor:
            return self._reported(editor, instruct(editor, args.instruction, args.planner, partly=args.partly))

    def provision(self, args: ProvisionArgs) -> AgentReport:
        """Make a task possible."""
        with self._edited(args.editor) as editor:
            return self._reported(editor, provision(editor, args.task))

    def cancel(self, args: CancelEdit) -> CanceledEdits:
        """Ask the running edit to end, where it is in the building that is named."""
        return CanceledEdits(editors=self._edits.cancel(lambda editor: args.editor in (None, editor)))

    @contextmanager
    def _edited(self, name: str) -> Iterator[SceneEditor]:
        """Yield an open editor; its work in the block ends when somebody cancels it or the node shuts down."""
        editor = self._editor(name)
        with (
            self._edits.begun(name) as asked_to_end,
            editor.cancellable(lambda: asked_to_end.is_set() or not self.context.ok()),
        ):
            yield editor

    def _reported(self, editor: SceneEditor, report: AgentReport) -> AgentReport:
        if report.saved:
            self._landed(editor, [])
        return report

    def _tool(self, tool: str) -> Callable[[Any], Any]:
        def call(args: Any) -> Any:
            with self._edited(args.editor) as editor:
                reply = editor.call(tool, args)
                if getattr(reply, "transaction", None) is not None:
                    self._landed(editor, [int(floor) for floor in reply.revisions])
                return reply

        return call

    def _editor(self, name: str) -> SceneEditor:
        editor = self._editors.get(name)
        if editor.engine.name != (physics := self._physics()):
            editor.engine = engine_named(physics)
        return editor

    def _physics(self) -> str:
        return str(self.get_parameter("physics").value)

    def _landed(self, editor: SceneEditor, floors: Sequence[int]) -> None:
        log = editor.store.edit_log
        for floor in floors or log.transaction(len(log)).revisions:
            self._scenes.publish(editor.state.scenes[int(floor)])
        self._finish(editor.store)

    def _finish(self, store: BuildingStore) -> None:
        """Have the files that are made from scenes written, after the reply."""
        if hasattr(self._hooks, "kept_files"):
            self._derived.update(store.folder)

    def _tell_written(self, folder: Path, floors: Sequence[int]) -> None:
        self.get_logger().info(f"{folder}: wrote the files of floors {floors}")

    def _tell_behind(self, folder: Path, error: Exception) -> None:
        self.get_logger().error(f"{folder}: derived files are behind: {error}")

    def destroy_node(self) -> None:
        """End the process that writes files, then the node."""
        self._derived.close()
        super().destroy_node()


def _time() -> str:
    """Return the time of day for a building's log, which simulated time says nothing about."""
    return datetime.now(UTC).replace(microsecond=0).isoformat()


def _accept_physics(parameters: Sequence[Parameter]) -> SetParametersResult:
    """Refuse an engine that there is not."""
    for parameter in parameters:
        if parameter.name == "physics":
            try:
                engine_named(str(parameter.value))
            except MansionError as error:
                return SetParametersResult(successful=False, reason=error.info.message)
    return SetParametersResult(successful=True)


def _snake(name: str) -> str:
    return re.sub(r"(?<=[a-z])(?=[A-Z])", "_", name).lower()


def _load_hooks(name: str) -> ModuleType:
    try:
        return import_module(name)
    except ImportError as error:
        raise MansionError(
            ErrorCode.UNAVAILABLE, f"the parameter hooks names {name!r}, which cannot be imported: {error}"
        ) from None


def main(args: Sequence[str] | None = None) -> None:
    """Run the node."""
    run_node(SceneEditorNode, args)


if __name__ == "__main__":
    main()
