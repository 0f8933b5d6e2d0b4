"""All that crosses a boundary in Mansion: payload types, their JSON codec, and the names of topics and services.

The types live in one module for each stage (`request`, `program`, `topology`, `layout`, `placement`, `scene`, `world`,
`building`); `payloads` lists them by name, `codec` turns them into JSON and back, `errors` holds the error object,
`interfaces` the table of topics and services.
"""

__version__ = "0.1.0"
