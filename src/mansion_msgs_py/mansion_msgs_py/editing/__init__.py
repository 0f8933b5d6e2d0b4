"""Arguments and replies of the scene editor's tools, and what an edit changes.

The names and inputs of the eight tools of the check-and-provision workflow are those of its tool cards (supplement,
D.2): CheckPath, SearchAssets, ListObjects, CheckSurface, SearchContents, PlaceInContainer, RemoveObject,
PlaceOnSurface. Every one takes `editor` besides, the name that ``scene/open`` gave a building on the server.
"""
