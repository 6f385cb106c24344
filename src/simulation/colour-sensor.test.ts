import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { colourNamed } from '#robots/colour-names';
import { frontOf } from '#robots/colour-sensor';
import { robotTypes } from '#robots/index';
import { defaultScene, type Scene, type SceneObject } from '#scene/scene';
import type { PaintColor } from '#scene/paint/paint';
import { soloRun } from './run-setup';
import { Simulation } from './simulation';

const firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));

/** A sheet of paper under the front edge of a Lite at (300 | 300) that looks along +x. */
const paper = (color: PaintColor): SceneObject => ({ type: 'paper', id: 'paper', at: [358, 300], size: [110, 110], angle: 0, color }); // prettier-ignore

const sceneOf = (...objects: readonly SceneObject[]): Scene => {
  const scene = defaultScene();
  return { ...scene, robot: { ...scene.robot, at: [300, 300], heading: 0 }, objects };
};

interface Run {
  readonly robot?: string;
  readonly options?: Readonly<Record<string, string>>;
  readonly forMs?: number;
  readonly board?: string;
}

async function run(program: string, scene: Scene, { robot = 'maqueen-lite', options, forMs = 1500, board }: Run = {}) {
  const simulation = await Simulation.create(
    {
      ...soloRun({
        ...{ scene, files: { 'main.py': program }, robot, board: board ?? 'microbit-v2', seed: 1, reality: 0 },
        robotOptions: options ?? { colour: 'tcs34725' },
      }),
      keepTrace: true,
    },
    firmware,
  );
  simulation.advanceTo(forMs * 1000);
  expect(simulation.ended?.exception ?? null).toBeNull();
  return { simulation, lines: simulation.takeConsole().trim().split(/\r?\n/) };
}

const NAMES = ['white', 'gray', 'black', 'red', 'orange', 'yellow', 'green', 'blue', 'purple', 'brown'] as const;

describe('the library colour', () => {
  it.each(NAMES)('calls %s paper so, and so does the page', async (name) => {
    const { lines, simulation } = await run(
      'import colour\nprint(colour.name())\nprint(*colour.raw())',
      sceneOf(paper(name)),
    );
    const [first, second = ''] = lines;
    expect(first).toBe(name);
    const [clear = 0, red = 0, green = 0, blue = 0] = second.split(' ').map(Number);
    const seen = simulation.snapshot().robot?.state.colours?.[0];
    expect(seen?.raw).toEqual([clear, red, green, blue]);
    expect(seen?.name).toBe(name);
    expect(colourNamed([clear, red, green, blue])).toEqual({ name: seen?.name, hue: seen?.hue });
  });

  it('measures hue, brightness and rgb against white paper, which can be calibrated anew', async () => {
    const program =
      'import colour\nprint(colour.hue(), colour.brightness(), *colour.rgb())\ncolour.calibrate()\nprint(colour.name(), *colour.rgb())';
    const { lines } = await run(program, sceneOf(paper('green')));
    expect(lines).toEqual(['125 40 68 152 75', 'white 255 255 255']);
  });

  it('mixes on the edge of two papers by area: half red and half white is neither', async () => {
    const edge: SceneObject = { ...paper('red'), at: [413, 300] } as SceneObject;
    const { lines } = await run('import colour\nprint(*colour.raw())', sceneOf(edge));
    const [clear = 0, red = 0] = (lines[0] ?? '').split(' ').map(Number);
    expect(clear).toBeCloseTo((7000 + 2476) / 2, -2);
    expect(red).toBeCloseTo((2018 + 1417) / 2, -2);
  });

  it('sees a thing ahead within 60 mm by its colour, and nothing beyond', async () => {
    const block = (x: number): SceneObject => ({ type: 'block', id: 'b', at: [x, 300], size: [40, 40], angle: 0, color: 'blue' }); // prettier-ignore
    const program = 'import colour\nprint(colour.name())';
    const options = { colourAhead: 'tcs34725' };
    const near = await run(program, sceneOf(block(398)), { options });
    const far = await run(program, sceneOf(block(460)), { options });
    expect([near.lines, far.lines]).toEqual([['blue'], ['black']]);
  });

  it('reads two sensors, the one ahead at 0x39', async () => {
    const wall: SceneObject = { type: 'wall', id: 'w', from: [380, 200], to: [380, 400], thickness: 10, color: 'red' };
    const program = 'import colour\nprint(colour.name(), colour.name(0x39))';
    const options = { colour: 'tcs34725', colourAhead: 'tcs34725' };
    expect((await run(program, sceneOf(paper('green'), wall), { options })).lines).toEqual(['green red']);
  });
});

/** Programs with the ways in which drivers of strangers read the sensor. */
const drivers = {
  // Pimoroni's tcs3472 and Vittascience's copy of it: 511 ms, gain 1, eight bytes at once, 255 · channel / clear.
  pimoroni: `
from microbit import *
import struct
i2c.write(0x29, b'\\x80\\x03')
i2c.write(0x29, b'\\x81\\x2b')
def valid():
    i2c.write(0x29, b'\\x93')
    return i2c.read(0x29, 1)[0] & 1 > 0
while not valid():
    sleep(10)
sleep(520)
i2c.write(0x29, b'\\xb4')
c, r, g, b = struct.unpack('<HHHH', i2c.read(0x29, 8))
print(*[int(255 * x / c) for x in (r, g, b)])`,
  // Grove colour sensor V2, Vittascience's color_sensor: gain 4, 24 ms, words one by one.
  grove: `
from microbit import *
def write8(reg, value):
    i2c.write(0x29, bytes([0x80 | reg, value]))
def word(reg):
    i2c.write(0x29, bytes([0xA0 | reg]))
    low, high = i2c.read(0x29, 2)
    return low + (high << 8)
write8(0x01, 0xF6)
write8(0x0F, 0x01)
write8(0x00, 0x01)
sleep(3)
write8(0x00, 0x03)
sleep(50)
print(*[word(reg) for reg in (0x14, 0x16, 0x18, 0x1A)])`,
  // In Adafruit's manner: the id is checked first, several cycles of wait, the interrupt is cleared.
  adafruit: `
from microbit import *
def read(reg, n=1):
    i2c.write(0x29, bytes([0xA0 | reg]))
    return i2c.read(0x29, n)
if read(0x12)[0] not in (0x44, 0x4D, 0x10):
    raise RuntimeError('wrong sensor id')
i2c.write(0x29, b'\\xe6')
i2c.write(0x29, bytes([0x81, 256 - 20]))
i2c.write(0x29, bytes([0x8F, 0]))
i2c.write(0x29, bytes([0x80, read(0)[0] | 1]))
sleep(3)
i2c.write(0x29, bytes([0x80, read(0)[0] | 2]))
while not read(0x13)[0] & 1:
    sleep(1)
d = read(0x14, 8)
print(*[d[i] | d[i + 1] << 8 for i in (0, 2, 4, 6)])`,
};

describe('drivers of strangers', () => {
  it('read the same as on the real sensor: Pimoroni’s rgb, Grove’s words, Adafruit’s id', async () => {
    const scene = sceneOf(paper('red'));
    expect((await run(drivers.pimoroni, scene)).lines).toEqual(['145 57 51']);
    expect((await run(drivers.grove, scene)).lines).toEqual(['2476 1417 558 501']);
    expect((await run(drivers.adafruit, scene)).lines).toEqual(['1238 709 279 251']);
  });
});

describe('a colour sensor', () => {
  it.each(robotTypes.map((type) => [type.id, type] as const))(
    'is carried by %s at its front edge',
    async (id, type) => {
      const front = frontOf(type).x;
      const sheet = { ...paper('blue'), at: [300 + Math.round(front), 300], size: [20, 20] } as SceneObject;
      const { lines } = await run('import colour\nprint(colour.name())', sceneOf(sheet), {
        robot: id,
        board: type.board,
      });
      expect(lines).toEqual(['blue']);
    },
  );

  it('is not on the bus without the option', async () => {
    const program = 'from microbit import *\nprint(0x29 in i2c.scan())';
    expect((await run(program, sceneOf(), { options: {} })).lines).toEqual(['False']);
  });
});

describe('line sensors over paper', () => {
  const program = 'from mbrobot import *\nprint(irLeft.read_digital())';
  const under = (more: Partial<SceneObject>): Scene =>
    sceneOf({ ...paper('green'), at: [340, 300], ...more } as SceneObject);
  it('see it by its infrared, not by its colour: green print is light, black is dark', async () => {
    expect((await run(program, under({}))).lines).toEqual(['1']);
    expect((await run(program, under({ color: 'black' }))).lines).toEqual(['0']);
    expect((await run(program, under({ infrared: 0.1 }))).lines).toEqual(['0']);
  });

  it('do not see a target without paint, nor a wish for blocks of a colour', async () => {
    const target: SceneObject = { type: 'target', id: 't', at: [340, 300], size: [110, 110], angle: 0, round: false, number: 0, blocks: 1, blockColor: 'black' }; // prettier-ignore
    expect((await run(program, sceneOf(target))).lines).toEqual(['1']);
    expect((await run(program, sceneOf({ ...target, color: 'black' }))).lines).toEqual(['0']);
  });
});

describe('a drive over papers', () => {
  it('is the same to the last bit', async () => {
    const sheets = (['red', 'green', 'blue', 'yellow'] as const).map((color, i): SceneObject => ({ ...paper(color), id: color, at: [450 + 120 * i, 300] }) as SceneObject); // prettier-ignore
    const program =
      'from mbrobot import *\nimport colour\nsetSpeed(30)\nforward()\nwhile colour.name() != "blue":\n    pass\nstop()\nprint("blue")';
    const { simulation, lines } = await run(program, sceneOf(...sheets), { forMs: 8000 });
    expect(lines).toEqual(['blue']);
    expect(simulation.traceHash).toBe('48061b5c9fe37ed4e207774185971177083d45f4eb415beed6eae2783753d6f1');
  });
});
