"""Retrieval of assets by a query: text search, or embeddings of text and pictures."""
