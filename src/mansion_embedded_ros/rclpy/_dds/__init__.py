"""Cyclone DDS through its C interface: domains, endpoints carrying ready-made CDR, discovery.

The calls go through ``ctypes``, which releases the interpreter lock while one runs, so that neither a
write that waits nor a large copy stops the other threads of the process.
"""
