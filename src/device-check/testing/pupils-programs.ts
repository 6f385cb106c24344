/** Programs as pupils and course books write them; all of them run on a micro:bit with firmware v2.1.2. */
export const pupilsPrograms: Readonly<Record<string, string>> = {
  heart: `
from microbit import *

while True:
    display.show(Image.HEART)
    sleep(500)
    display.clear()
    sleep(500)
`,
  dice: `
from microbit import *
import random

def wuerfle():
    zahl = random.randint(1, 6)
    display.show(zahl)
    return zahl

summe = 0
for i in range(10):
    summe += wuerfle()
    sleep(200)
print("Durchschnitt:", round(summe / 10, 1))
`,
  thermometer: `
from microbit import *

werte = []
while len(werte) < 5:
    werte.append(temperature())
    sleep(100)
mittel = sum(werte) / len(werte)
print("Mittel %.1f Grad" % mittel, max(werte), min(werte))
display.scroll("{:.1f}".format(mittel), delay=100)
`,
  compass: `
from microbit import *
compass.calibrate()
richtung = ((15 - compass.heading()) // 30) % 12
display.show(Image.ALL_CLOCKS[richtung])
`,
  fireflies: `
import radio
import random
from microbit import display, Image, button_a, sleep

flash = [Image().invert() * (i / 9) for i in range(9, -1, -1)]
radio.on()
while True:
    if button_a.was_pressed():
        radio.send('flash')
    incoming = radio.receive()
    if incoming == 'flash':
        sleep(random.randint(50, 350))
        display.show(flash, delay=100, wait=False)
        if random.randint(0, 9) == 0:
            sleep(500)
            radio.send('flash')
`,
  snake: `
from microbit import *
from random import randint

class Schlange:
    def __init__(self):
        self.laenge = 2
        self.richtung = "oben"
        self.kopf = [2, 2]
        self.koerper = []

    def bewege(self):
        self.koerper.append(self.kopf.copy())
        if len(self.koerper) > self.laenge:
            self.koerper = self.koerper[1:]
        if self.richtung == "oben":
            self.kopf[1] = (self.kopf[1] - 1) % 5

    def center(self, breite):
        return breite // 2

    def __str__(self):
        return "Schlange der Länge " + str(self.laenge)

spiel = Schlange()
for _ in range(3):
    spiel.bewege()
    display.set_pixel(spiel.kopf[0], spiel.kopf[1], 9)
print(spiel, spiel.center(5))
`,
  robot: `
from mbrobot import *

setSpeed(40)
try:
    while True:
        d = getDistance()
        if d < 20:
            right()
            delay(300)
        else:
            forward()
        delay(10)
except KeyboardInterrupt:
    stop()
`,
  logger: `
from microbit import *
import log

log.set_labels('x', 'y', timestamp=log.SECONDS)

@run_every(s=1)
def schreibe():
    log.add({'x': accelerometer.get_x(), 'y': accelerometer.get_y()})

while True:
    sleep(100000)
`,
  i2cDriver: `
from microbit import i2c, sleep
import struct

ADDRESS = 0x76
NARROW = const(3) if "const" in dir() else 3

def read(register, count):
    i2c.write(ADDRESS, bytes([register]), repeat=True)
    return i2c.read(ADDRESS, count)

def measure():
    raw = read(0xF7, 8)
    pressure = (raw[0] << 12) | (raw[1] << 4) | (raw[2] >> 4)
    low, high = struct.unpack('<hH', read(0x88, 4))
    buffer = bytearray(4)
    buffer[0] = low & 0xFF
    signed = int.from_bytes(buffer, 'little')
    return pressure / 256.0 + high + signed
`,
  timetable: `
from utime import ticks_ms, ticks_diff
start = ticks_ms()
plan = {"Mo": ["Mathe", "Sport"], "Di": ["Deutsch"]}
for tag, faecher in sorted(plan.items()):
    print(tag, *faecher, sep=" | ")
print(ticks_diff(ticks_ms(), start), [n ** 2 for n in range(5) if n % 2], {n: n for n in "abc"})
`,
  morse: `
from microbit import *
import music
MORSE = {'A': '.-', 'B': '-...'}

def morse(text: str, ton: int = 440) -> None:
    for zeichen in text.upper():
        for laenge in MORSE.get(zeichen, ''):
            music.pitch(ton, 100 if laenge == '.' else 300)
        sleep(200)

wort = input("Wort? ").strip().replace(" ", "")
if (n := len(wort)) > 3:
    print(n, "Buchstaben", 1_000)
morse(wort)
`,
  generator: `
def zaehle(bis):
    n = 0
    while n < bis:
        yield n
        n += 1

def alle():
    yield from zaehle(3)

zahlen = list(map(lambda x: x * 2, filter(None, alle())))
print(next(iter(zahlen)), any(zahlen), list(zip(zahlen, "ab")), list(enumerate(zahlen, 1)), sorted(zahlen, key=lambda x: -x))
with open('daten.txt', 'w') as datei:
    datei.write("\\n".join(str(z) for z in zahlen))
with open('daten.txt') as datei:
    for zeile in datei.read().split("\\n"):
        print(zeile.strip(), zeile.find("2"), zeile[::1])
`,
  vector: `
from math import sqrt, pi, atan2, degrees

class Vektor:
    def __init__(self, x=0, y=0):
        self.x, self.y = x, y

    def __add__(self, anderer):
        return Vektor(self.x + anderer.x, self.y + anderer.y)

    def __repr__(self):
        return "Vektor({}, {})".format(self.x, self.y)

    @property
    def laenge(self):
        return sqrt(self.x ** 2 + self.y ** 2)

    @staticmethod
    def null():
        return Vektor()

class Pfeil(Vektor):
    def __init__(self, *args, **kwargs):
        super().__init__(*args, **kwargs)
        self.winkel = degrees(atan2(self.y, self.x)) % (2 * pi)

print(Pfeil(3, 4) + Vektor.null(), Pfeil(3, y=4).laenge, type(Pfeil()).__name__)
`,
};
