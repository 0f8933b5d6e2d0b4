"""The language-model planner: the same payloads and the same rules as the offline planner, its answers by a model.

Each piece (numbers, materials, program of a floor, cores, room graph, seeds of a cut round) is asked for, checked,
asked for again with the faults listed, and else taken from the offline planner. The reply says which came from where.
"""
