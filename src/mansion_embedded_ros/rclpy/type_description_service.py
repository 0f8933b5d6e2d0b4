"""The service that gives the description of the types a node uses."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rclpy.qos import qos_profile_services_default

from rosidl_embedded.definition import InterfaceNotFoundError, MessageDefinition, load_package
from rosidl_embedded.registry import get_interface, type_hash
from rosidl_embedded.type_description import type_description
from type_description_interfaces.msg import (
    Field,
    FieldType,
    IndividualTypeDescription,
    KeyValue,
    TypeDescription,
    TypeSource,
)
from type_description_interfaces.srv import GetTypeDescription

if TYPE_CHECKING:
    from rclpy.node import Node

__all__ = ["START_TYPE_DESCRIPTION_SERVICE_PARAM", "TypeDescriptionService"]

START_TYPE_DESCRIPTION_SERVICE_PARAM = "start_type_description_service"


def _individual(data: dict[str, Any]) -> IndividualTypeDescription:
    return IndividualTypeDescription(
        type_name=data["type_name"],
        fields=[
            Field(name=field["name"], type=FieldType(**field["type"])) for field in data["fields"]
        ],
    )


def _source(name: str) -> TypeSource:
    package, kind, _short = name.split("/")
    definition = load_package(package).get(name)
    if definition is None:
        return TypeSource(type_name=name, encoding="implicit")
    text = definition.text
    encoding = "msg" if isinstance(definition, MessageDefinition) else kind
    return TypeSource(type_name=name, encoding=encoding, raw_file_contents=f"{text}\n")


class TypeDescriptionService:
    """Made by a node for itself, unless its parameter says no."""

    def __init__(self, node: Node):
        self._node = node
        if not node.has_parameter(START_TYPE_DESCRIPTION_SERVICE_PARAM):
            from rcl_interfaces.msg import ParameterDescriptor

            node.declare_parameter(
                START_TYPE_DESCRIPTION_SERVICE_PARAM,
                True,
                ParameterDescriptor(
                    name=START_TYPE_DESCRIPTION_SERVICE_PARAM,
                    description="If enabled, start the ~/get_type_description service.",
                    read_only=True,
                ),
            )
        self.enabled = bool(node.get_parameter(START_TYPE_DESCRIPTION_SERVICE_PARAM).value)
        if self.enabled:
            node.create_service(
                GetTypeDescription,
                f"{node.get_name()}/get_type_description",
                self._answer,
                qos_profile=qos_profile_services_default,
            )

    def _answer(
        self, request: GetTypeDescription.Request, response: GetTypeDescription.Response
    ) -> GetTypeDescription.Response:
        name = request.type_name
        try:
            cls = get_interface(name)
            data = type_description(name)
        except (InterfaceNotFoundError, ValueError, AttributeError):
            response.successful = False
            response.failure_reason = f"Type '{name}' is not currently in use by this node"
            return response
        if request.type_hash and request.type_hash != type_hash(cls):
            response.successful = False
            response.failure_reason = (
                f"Type '{name}' has hash {type_hash(cls)}, not {request.type_hash}"
            )
            return response
        own, referenced = data["type_description"], data["referenced_type_descriptions"]
        response.successful = True
        response.type_description = TypeDescription(
            type_description=_individual(own),
            referenced_type_descriptions=[_individual(r) for r in referenced],
        )
        if request.include_type_sources:
            response.type_sources = [_source(d["type_name"]) for d in (own, *referenced)]
        response.extra_information = [KeyValue(key="implementation", value="mansion_embedded_ros")]
        return response
