"""What finds assets by words: text search, or embeddings of text and pictures."""
