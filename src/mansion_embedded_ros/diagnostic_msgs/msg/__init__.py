"""Messages of ``diagnostic_msgs``, made from its interface definitions when first used."""

from rosidl_embedded.package_modules import populate

__all__, __getattr__ = populate(__name__)
