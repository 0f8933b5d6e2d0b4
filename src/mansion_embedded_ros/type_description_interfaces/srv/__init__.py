"""Services of ``type_description_interfaces``, made from its interface definitions when first used."""

from rosidl_embedded.package_modules import populate

__all__, __getattr__ = populate(__name__)
