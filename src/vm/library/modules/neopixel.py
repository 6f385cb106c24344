# NeoPixel as on the device: colours are kept in the order green, red, blue (, white) of the ws2812.
import _hal
from microbit import ws2812_write

_spend = _hal.spend_neopixel


class NeoPixel:
    ORDER = (1, 0, 2, 3)

    # The device's class is Python, too: _self makes its errors those of Python (src/vm/firmware/native-calls.mjs).
    def __init__(_self, pin, n, bpp=3):
        _self.pin = pin
        _self.n = n
        _self.bpp = bpp
        _self.buf = bytearray(n * bpp)

    def __setitem__(self, index, color):
        _spend()
        place = index * self.bpp
        for part in range(self.bpp):
            self.buf[place + self.ORDER[part]] = color[part]

    def __getitem__(self, index):
        _spend()
        place = index * self.bpp
        return tuple(self.buf[place + self.ORDER[part]] for part in range(self.bpp))

    def __len__(self):
        return self.n

    def fill(self, color):
        for index in range(self.n):
            self[index] = color

    def write(self):
        ws2812_write(self.pin, self.buf)

    show = write

    def clear(self):
        for place in range(len(self.buf)):
            self.buf[place] = 0
        self.write()
