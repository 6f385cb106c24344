import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import { defaultScene, type Barrier, type Lamp, type Scene, type SceneObject } from '#scene/scene';
import type { InputEvent } from '../input';
import { soloRun, type DeviceSetup, type RunSetup } from '../run-setup';
import { Simulation } from '../simulation';

let firmware: WebAssembly.Module;
beforeAll(async () => {
  firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));
});

const lamp = (of: Partial<Lamp> = {}): Lamp => ({
  ...{ type: 'lamp', id: 'lamp', at: [600, 450], height: 260, brightness: 40 },
  ...of,
});
const barrier = (of: Partial<Barrier> = {}): Barrier => ({
  ...{ type: 'barrier', id: 'gate', from: [800, 300], to: [800, 600], thickness: 10, opens: 'hand' },
  ...of,
});
const course = (objects: readonly SceneObject[], of: Partial<Scene> = {}): Scene => ({
  ...{ ...defaultScene(), ambient: 0, objects },
  ...of,
});

/** A run of one robot in the middle of the arena. */
function run(scene: Scene, program: string, inputs: readonly InputEvent[] = [], robot = 'maqueen-plus-v3') {
  const files = { 'main.py': program };
  const solo = { scene, files, robot, board: 'auto', seed: 1, reality: 0, inputs };
  return Simulation.create(soloRun(solo), firmware);
}

const LEVELS = 'from microbit import *\nwhile True:\n    print(display.read_light_level())\n    sleep(500)\n';

describe('the light sensors of a run', { timeout: 30_000 }, () => {
  it('read as always without a lamp: 127, 508 on a V3', async () => {
    const program = `from microbit import *\ni2c.write(0x10, bytes([78]))\nprint(display.read_light_level(), i2c.read(0x10, 4))\n`;
    const simulation = await run(course([], { ambient: 300 }), program);
    simulation.advanceTo(300_000);
    expect(simulation.takeConsole()).toBe("127 b'\\x01\\xfc\\x01\\xfc'\n");
  });

  it('see a lamp right above, 200 mm over the eye, as 1000 lx: level 196, and darkness as 0', async () => {
    const levels = async (scene: Scene): Promise<string> => {
      const simulation = await run(scene, LEVELS);
      simulation.advanceTo(400_000);
      return simulation.takeConsole().trim();
    };
    expect(await levels(course([lamp()]))).toBe('196');
    expect(await levels(course([lamp({ on: 'hand' })]))).toBe('0');
    expect(await levels(course([{ type: 'tunnel', id: 't', at: [600, 450], size: [400, 200], angle: 0 }], { ambient: 300 }))).toBe('2'); // prettier-ignore
  });

  it('read more on the side of the lamp, on a V3 and a bit:bot', async () => {
    const left = course([lamp({ at: [600, 700] })]);
    const v3 = await run(left, 'from microbit import *\ni2c.write(0x10, bytes([78]))\nb = i2c.read(0x10, 4)\nprint(b[0] * 256 + b[1] > b[2] * 256 + b[3] + 50)\n'); // prettier-ignore
    v3.advanceTo(300_000);
    expect(v3.takeConsole()).toBe('True\n');
    const bitbot = await run(left, 'from microbit import *\nsleep(50)\nprint(pin2.read_analog() > pin1.read_analog() + 50)\n', [], 'bitbot-xl'); // prettier-ignore
    bitbot.advanceTo(500_000);
    expect(bitbot.takeConsole()).toBe('True\n');
  });

  it('are overruled by a level that is set by hand, until the run ends', async () => {
    const byHand = { timeUs: 600_000, action: { type: 'sensor', id: 'lightLevel', value: 12 } } as const;
    const simulation = await run(course([lamp()]), LEVELS, [byHand]);
    simulation.advanceTo(1_900_000);
    expect(simulation.takeConsole().split('\n')).toEqual(['196', '196', '12', '12', '']);
  });
});

describe('a lamp', { timeout: 30_000 }, () => {
  const seen = async (on: Lamp['on'], inputs: readonly InputEvent[] = []): Promise<string> => {
    const simulation = await run(course([lamp(on && { on })]), LEVELS, inputs);
    simulation.advanceTo(2_900_000);
    return simulation
      .takeConsole()
      .split('\n')
      .map((level) => (level === '196' ? 'I' : level === '0' ? 'o' : ''))
      .join('');
  };

  it('shines by the time, on at first', async () => {
    expect(await seen({ time: [0.9, 0.6] })).toBe('IIoIIo');
  });

  it('is switched by a radio text from outside, by a button, and by hand, and is off at first', async () => {
    const radio = (ms: number, text: string): InputEvent => ({ timeUs: ms * 1000, action: { type: 'radio', text } });
    expect(await seen({ radio: ['an', 'aus'] }, [radio(700, 'an'), radio(1200, 'egal'), radio(1700, 'aus')])).toBe('ooIIoo'); // prettier-ignore
    const press = (ms: number, down: boolean): InputEvent => ({ timeUs: ms * 1000, action: { type: 'button', button: 'a', down } }); // prettier-ignore
    expect(await seen({ button: 'a' }, [press(700, true), press(900, false), press(1700, true)])).toBe('ooIIoo');
    const hand = (ms: number, on: boolean): InputEvent => ({ timeUs: ms * 1000, action: { type: 'switch', id: 'lamp', on } }); // prettier-ignore
    expect(await seen('hand', [hand(700, true), hand(1700, false)])).toBe('ooIIoo');
  });

  it('follows the pin of the first board without a robot', async () => {
    const light = 'from microbit import *\nsleep(700)\npin1.write_digital(1)\nsleep(1000)\npin1.write_digital(0)\n';
    const own = (name: string, program: string, robot: string): DeviceSetup => ({ ...{ name, robot, board: 'auto' }, files: { 'main.py': program } }); // prettier-ignore
    const setup: RunSetup = {
      ...{ scene: course([lamp({ on: { pin: 'P1' } })]), seed: 1, reality: 0 },
      devices: [own('car', LEVELS, 'maqueen-plus-v3'), own('light', light, 'none')],
    };
    const simulation = await Simulation.create(setup, firmware);
    simulation.advanceTo(2_400_000);
    expect(simulation.takeConsole().split('\n').slice(0, 5)).toEqual(['0', '0', '196', '196', '0']);
  });

  it('cannot be switched by hand if something else switches it', async () => {
    const simulation = await run(course([lamp()]), '');
    expect(() => simulation.input({ type: 'switch', id: 'lamp', on: false })).toThrow(
      'There is no lamp or barrier "lamp" that is switched by hand. This course has none.',
    );
  });
});

describe('a barrier', { timeout: 30_000 }, () => {
  const DRIVE = 'from mbrobot_plusV3 import *\nsetSpeed(60)\nforward()\ndelay(6000)\nstop()\n';
  const open: InputEvent = { timeUs: 3_000_000, action: { type: 'switch', id: 'gate', on: true } };

  it('holds the robot until the hand opens it; the snapshot tells, and the log repeats the run bit for bit', async () => {
    const simulation = await run(course([barrier()]), DRIVE);
    simulation.advanceTo(3_000_000);
    expect([simulation.snapshot().switched, (simulation.pose?.xMm ?? 0) < 800]).toEqual([{ gate: false }, true]);
    simulation.input(open.action);
    simulation.advanceTo(4_500_000);
    expect([simulation.snapshot().switched, (simulation.pose?.xMm ?? 0) > 850]).toEqual([{ gate: true }, true]);
    const again = await run(course([barrier()]), DRIVE, simulation.inputLog);
    again.advanceTo(4_500_000);
    expect(again.traceHash).toBe(simulation.traceHash);
  });

  it('opens to the words that a program sends by radio', async () => {
    const program = `import radio\nradio.on()\nradio.send('open')\n${DRIVE}`;
    const simulation = await run(course([barrier({ opens: { radio: ['open', 'close'] } })]), program);
    simulation.advanceTo(3_000_000);
    expect(simulation.pose?.xMm).toBeGreaterThan(850);
  });
});

it(
  'a light seeker among lamps, walls, a barrier and a ball drives the recorded way, to the last bit',
  { timeout: 30_000 },
  async () => {
    const scene = course(
      [
        lamp({ at: [950, 700], brightness: 60 }),
        lamp({ id: 'lamp-2', at: [300, 150], on: { time: [1.5, 1] } }),
        { type: 'wall', id: 'wall', from: [700, 550], to: [900, 550], thickness: 10 },
        { type: 'block', id: 'ball', at: [750, 450], size: [40, 40], angle: 0, round: true, mass: 3, rolls: true },
        barrier({ from: [900, 350], to: [900, 500], opens: { time: [2, 2] } }),
      ],
      { ambient: 20 },
    );
    const seek = `from mbrobot_plusV3 import *
from microbit import i2c
setSpeed(40)
while True:
    i2c.write(0x10, bytes([78]))
    b = i2c.read(0x10, 4)
    if b[0] * 256 + b[1] > b[2] * 256 + b[3]:
        leftArc(0.1)
    else:
        rightArc(0.1)
    delay(20)
`;
    const simulation = await run(scene, seek);
    simulation.advanceTo(8_000_000);
    const { xMm = 0, yMm = 0 } = simulation.pose ?? {};
    const rounded = [xMm, yMm].map((mm) => Math.round(mm * 1000) / 1000);
    expect({ rounded, hash: simulation.traceHash }).toEqual({
      rounded: [598.056, 364.241],
      hash: 'b8e227d9bbaedb1cbe01d0d26eb266a8c39a62efc0774a21eb0e4dc5415c86e6',
    });
  },
);
