import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { robotTypes } from '#robots/index';
import { defaultScene, type Scene, type SceneObject } from '#scene/scene';
import { soloRun } from './run-setup';
import { Simulation } from './simulation';

const firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));

/** A robot at (300 | 300) that looks along +x. */
const sceneOf = (...objects: readonly SceneObject[]): Scene => {
  const scene = defaultScene();
  return { ...scene, robot: { ...scene.robot, at: [300, 300], heading: 0 }, objects };
};
const block = (color: 'red' | 'blue' | 'gray', x: number, y: number): SceneObject => ({ type: 'block', id: `${color}${x}`, at: [x, y], size: [40, 40], angle: 0, color }); // prettier-ignore
const line = (...points: readonly (readonly [number, number])[]): SceneObject => ({ type: 'stroke', id: 'line', points, width: 20, color: 'black' }); // prettier-ignore

interface Run {
  readonly robot?: string;
  readonly options?: Readonly<Record<string, string>>;
  readonly forMs?: number;
  readonly board?: string;
}

async function run(program: string, scene: Scene, { robot = 'maqueen-lite', options, forMs = 2500, board }: Run = {}) {
  const simulation = await Simulation.create(
    {
      ...soloRun({
        ...{ scene, files: { 'main.py': program }, robot, board: board ?? 'microbit-v2', seed: 1, reality: 0 },
        robotOptions: options ?? { camera: 'huskylens' },
      }),
      keepTrace: true,
    },
    firmware,
  );
  simulation.advanceTo(forMs * 1000);
  expect(simulation.ended?.exception ?? null).toBeNull();
  return { simulation, lines: simulation.takeConsole().trim().split(/\r?\n/) };
}

const ask = (algorithm: string, what: string): string =>
  `from huskylens import *\nh = Huskylens()\nprint(h.initialize(), h.set_algorithm(Algorithm.${algorithm}))\n${what}`;

describe('the library huskylens', () => {
  it('finds coloured blocks and fields by the numbers of their colours, the larger first, and no grey one', async () => {
    const field: SceneObject = { type: 'paper', id: 'p', at: [560, 180], size: [80, 80], angle: 0, color: 'green' };
    const program = ask('COLOR_RECOGNITION', 'for b in h.get_all():\n    print(b)');
    const { lines } = await run(program, sceneOf(block('red', 560, 300), block('blue', 760, 420), block('gray', 560, 380), field)); // prettier-ignore
    expect(lines).toEqual([
      'True True',
      'Block 1 at (160, 107), 80 x 125',
      'Block 4 at (45, 162), 50 x 65',
      'Block 3 at (300, 62), 40 x 45',
    ]);
  });

  it('finds the nearest to the middle, and those with an id', async () => {
    const program = ask('COLOR_RECOGNITION', 'print(h.get_one().id, h.get_one_with_id(4).id, h.get_one_with_id(2), len(h.get_all_with_id(1)))'); // prettier-ignore
    const { lines } = await run(program, sceneOf(block('red', 560, 300), block('blue', 760, 420)));
    expect(lines[1]).toBe('1 4 None 1');
  });

  it('follows a line from near to far: straight ahead is 0 degrees, one to the right more', async () => {
    const program = ask('LINE_TRACKING', 'a = h.get_one()\nprint(a.x_tail, a.y_tail < a.y_head, a.get_direction())');
    const straight = await run(program, sceneOf(line([200, 300], [900, 300])), {
      options: { camera: 'huskylens-down' },
    });
    expect(straight.lines[1]).toBe('160 True 0');
    const right = await run(program, sceneOf(line([200, 300], [430, 300], [600, 200])), { options: { camera: 'huskylens-down' } }); // prettier-ignore
    expect(Number(right.lines[1]?.split(' ')[2])).toBeGreaterThan(20);
  });

  it('sees no line on the bare floor, and no faces', async () => {
    expect((await run(ask('LINE_TRACKING', 'print(h.get_all(), h.get_one())'), sceneOf())).lines[1]).toBe('[] None');
    expect((await run(ask('FACE_RECOGNITION', 'print(h.get_all())'), sceneOf())).lines[1]).toBe('[]');
  });

  it('finds AprilTags upright and on the floor by their numbers, not from behind, and learns one anew', async () => {
    const tag = (number: number, x: number, y: number, more: object): SceneObject => ({ type: 'tag', id: `t${number}`, at: [x, y], number, side: 60, angle: 180, ...more }); // prettier-ignore
    const program = ask(
      'TAG_RECOGNITION',
      'print([(b.id, b.x) for b in h.get_all()])\nh.forget()\nprint(sorted([b.id for b in h.get_all()]))\nh.learn(2)\nprint(h.get_one_learned().x)',
    );
    const wall: SceneObject = { type: 'wall', id: 'w', from: [800, 100], to: [800, 500], thickness: 10 };
    const scene = sceneOf(
      wall,
      tag(5, 795, 300, {}),
      tag(12, 600, 240, { flat: true }),
      tag(7, 700, 400, { angle: 0 }),
    );
    const { lines } = await run(program, scene);
    expect(lines).toEqual(['True True', '[(5, 160), (12, 254)]', '[0, 0]', '160']);
  });

  it('raises OSError without a camera', async () => {
    const program = 'from huskylens import *\ntry:\n    Huskylens()\nexcept OSError as e:\n    print(e)';
    expect((await run(program, sceneOf(), { options: {} })).lines).toEqual(['[Errno 19] ENODEV']);
  });
});

/** Programs with the ways in which drivers of strangers talk to the camera. */
const drivers = {
  // WebTigerPython's module: 50 ms of patience, byte by byte up to 55, four more one by one, then the rest at once.
  webTigerPython: `
from microbit import *
def ask(command, data=[]):
    frame = bytearray([0x55, 0xAA, 0x11, len(data), command] + data)
    frame.append(sum(frame) & 0xFF)
    i2c.write(0x32, frame)
    sleep(50)
def answer():
    while i2c.read(0x32, 1)[0] != 0x55:
        pass
    head = [i2c.read(0x32, 1)[0] for _ in range(4)]
    return head[3], i2c.read(0x32, head[2] + 1)[:-1] if head[2] else i2c.read(0x32, 1)
ask(0x35)
print(answer()[0])
ask(0x3B)
print(list(answer()[1]))
ask(0x2D, [4, 0])
print(answer()[0])
ask(0x20)
print(list(answer()[1])[:2])
print(list(answer()[1]))`,
  // The maker's MakeCode blocks: 16 bytes at a time, fed to a machine that looks for frames.
  makeCode: `
from microbit import *
def frames(command, data=b''):
    f = b'\\x55\\xaa\\x11' + bytes([len(data), command]) + data
    i2c.write(0x32, f + bytes([sum(f) & 255]))
    sleep(50)
    got = b''
    for _ in range(4):
        got += i2c.read(0x32, 16)
    at = got.find(b'\\x55\\xaa\\x11')
    while at >= 0:
        n = got[at + 3]
        print(hex(got[at + 4]), list(got[at + 5:at + 5 + n]))
        at = got.find(b'\\x55\\xaa\\x11', at + 6 + n)
frames(0x2C)
frames(0x2D, b'\\x04\\x00')
frames(0x24)`,
  // The maker's Python library for other computers: each request behind a register byte 0C, replies byte by byte at once.
  register: `
from microbit import *
def ask(hexes):
    i2c.write(0x32, b'\\x0c' + bytes([int(hexes[i:i + 2], 16) for i in range(0, len(hexes), 2)]))
    head = [i2c.read(0x32, 1)[0] for _ in range(5)]
    rest = [i2c.read(0x32, 1)[0] for _ in range(head[3] + 1)]
    print(head[4], rest[:2])
ask('55AA11002C3C')
ask('55AA11022D040043')
ask('55AA11002030')`,
};

describe('drivers of strangers', () => {
  const scene = sceneOf(block('red', 560, 300));
  const red = '[160, 0, 133, 0, 80, 0, 125, 0, 1, 0]';
  it('get the same as from the real camera: WebTigerPython, MakeCode, the maker’s Python', async () => {
    expect((await run(drivers.webTigerPython, scene)).lines).toEqual(['46', '[0, 0]', '46', '[1, 0]', red]);
    const [knock, algorithm, info, seen] = (await run(drivers.makeCode, scene)).lines;
    expect([knock, algorithm, seen]).toEqual(['0x2e []', '0x2e []', `0x2a ${red}`]);
    expect(info).toMatch(/^0x29 \[1, 0, 7, 0, \d+, 0, 0, 0, 0, 0\]$/);
    expect((await run(drivers.register, scene)).lines).toEqual(['46 [62]', '46 [62]', '41 [1, 0]']);
  });
});

describe('a camera', () => {
  it('stays unplugged where a lidar of the robot has its address: that answers as ever', async () => {
    const options = { camera: 'huskylens', lidar: '8x8', lidarAddress: '0x32' };
    const program = 'from microbit import *\nsleep(3500)\nprint(i2c.scan())';
    const { simulation, lines } = await run(program, sceneOf(), { robot: 'maqueen-plus-v3', options, forMs: 4000 });
    expect(lines.join()).toContain('50');
    expect(simulation.snapshot().robot?.state).not.toHaveProperty('camera');
  });

  it.each(robotTypes.map((type) => [type.id, type] as const))(
    'is carried by %s at its front edge',
    async (id, type) => {
      const program = ask('COLOR_RECOGNITION', 'print([b.id for b in h.get_all()])');
      const { lines } = await run(program, sceneOf(block('blue', 560, 300)), { robot: id, board: type.board });
      expect(lines[1]).toBe('[4]');
    },
  );

  it('shows what the program got last, and nothing while it does not ask', async () => {
    const program = ask('COLOR_RECOGNITION', 'import microbit\nwhile microbit.running_time() < 900:\n    h.get_all()');
    const { simulation } = await run(program, sceneOf(block('red', 560, 300)), { forMs: 1000 });
    const state = simulation.snapshot().robot?.state.camera;
    expect(state?.algorithm).toBe('colour');
    expect(state?.seen?.map(({ id }) => id)).toEqual([1]);
    simulation.advanceTo(2_000_000);
    expect(simulation.snapshot().robot?.state.camera?.seen).toBeNull();
  });

  it('follows a line to its end, the same to the last bit', async () => {
    const curve = line([200, 300], [500, 300], [700, 380], [800, 560], [780, 700]);
    const program = `
from mbrobot import *
from huskylens import *
h = Huskylens()
h.set_algorithm(Algorithm.LINE_TRACKING)
setSpeed(20)
while True:
    a = h.get_one()
    if a is None:
        break
    middle = (a.x_tail + a.x_head) // 2
    if middle < 140:
        leftArc(0.12)
    elif middle > 180:
        rightArc(0.12)
    else:
        forward()
stop()
print('end')`;
    const { simulation, lines } = await run(program, sceneOf(curve), { forMs: 30_000, options: { camera: 'huskylens-down' } }); // prettier-ignore
    const { xMm = 0, yMm = 0 } = simulation.snapshot().robot?.pose ?? {};
    expect(lines).toEqual(['end']);
    expect([Math.round(xMm), Math.round(yMm)]).toEqual([764, 606]);
    expect(simulation.traceHash).toBe('3ce583c6072761a2fe74d9616bff588e52a6c0849f3906e8893fe866fe2f13fb');
  });
});
