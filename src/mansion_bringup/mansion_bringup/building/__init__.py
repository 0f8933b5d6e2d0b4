"""A building on disk: the files of a floor, the folder, its report."""
