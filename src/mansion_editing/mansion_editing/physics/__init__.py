"""Physics on demand: an engine settles one new object among its neighbours and is gone afterwards."""
