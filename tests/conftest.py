"""Property tests draw the same examples in every run, unless a profile of Hypothesis is named."""

import os

from hypothesis import settings

settings.register_profile("same_each_run", derandomize=True)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "same_each_run"))
