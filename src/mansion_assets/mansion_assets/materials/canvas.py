"""The tile that a material is drawn on: its size in metres and in texels, and noise that repeats with it."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from mansion_geometry.compiled import Floats, Ints
from mansion_geometry.randomness import item_generator

__all__ = ["Canvas"]


@dataclass(frozen=True)
class Canvas:
    """A tile, row 0 on top.

    Attributes
    ----------
    name : str
        Whose noise it is: canvases of different names draw different numbers.
    size : (width, height)
        Metres.
    pixels : (columns, rows)
    """

    name: str
    size: tuple[float, float]
    pixels: tuple[int, int]

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns."""
        return self.pixels[1], self.pixels[0]

    @property
    def texel(self) -> tuple[float, float]:
        """Width and height of a texel, metres."""
        return self.size[0] / self.pixels[0], self.size[1] / self.pixels[1]

    @cached_property
    def places(self) -> tuple[Floats, Floats]:
        """Return x and y of the texels' middles, metres from the upper left corner."""
        x = (np.arange(self.pixels[0]) + 0.5) * self.texel[0]
        y = (np.arange(self.pixels[1]) + 0.5) * self.texel[1]
        across, down = np.meshgrid(x, y)
        return across, down

    def noise(self, salt: str, length: tuple[float, float]) -> Floats:
        """Return smooth noise of mean 0 and deviation 1 that repeats with the tile.

        White noise is filtered in the frequency domain by a Gaussian.

        Parameters
        ----------
        salt : str
            Which of the canvas's fields of noise.
        length : (along x, along y)
            How far the noise is alike, metres.
        """
        white = item_generator(0, self.name, salt).standard_normal(self.shape)
        fx = np.fft.rfftfreq(self.pixels[0], self.texel[0]) * length[0]
        fy = np.fft.fftfreq(self.pixels[1], self.texel[1]) * length[1]
        spectrum = np.fft.rfft2(white) * np.exp(-2.0 * (fx[None] ** 2 + fy[:, None] ** 2))
        spectrum[0, 0] = 0.0
        field: Floats = np.fft.irfft2(spectrum, s=self.shape)
        return field / max(float(field.std()), 1e-12)

    def clouds(self, salt: str, length: float, octaves: int = 4) -> Floats:
        """Return noise of several lengths, each half the one before and half as strong; deviation 1."""
        total = np.zeros(self.shape)
        for octave in range(octaves):
            step = length / 2**octave
            total += self.noise(f"{salt}/{octave}", (step, step)) / 2**octave
        return total / max(float(total.std()), 1e-12)

    def chances(self, salt: str, numbers: Ints) -> Floats:
        """Return a number from 0 to 1 for each texel, the same for equal `numbers`, which are not negative."""
        return item_generator(0, self.name, salt).random(int(numbers.max()) + 1)[numbers]

    def sample(self, field: Floats, x: Floats, y: Floats) -> Floats:
        """Return a field's values at places, metres, beyond the tile as in its next repetition."""
        columns = np.floor(x / self.texel[0]).astype(np.int64) % self.pixels[0]
        rows = np.floor(y / self.texel[1]).astype(np.int64) % self.pixels[1]
        found: Floats = field[rows, columns]
        return found
