import { spawn } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { OptionValues } from '#core/option';
import { parseScene } from '#scene/parse';
import { defaultScene, type Lamp, type Paper, type Scene, type Stroke } from '#scene/scene';
import { soloRun, type DeviceSetup, type RunSetup } from '#simulation/run-setup';
import { Simulation } from '#simulation/simulation';
import { TapeBox } from '#web/session/run/worker/tape-box';
import { atBreakPoints } from '#vm/debug/stops';
import { checkMemorySubject, checkSubject, sweepSubject, tournamentSubject } from './check';
import { FULL, fullCourse } from './full-course';
import type { Subject } from './subject';

/** Everything is measured so often, and the best counts: other work on the machine only ever makes a run slower. */
const ROUNDS = 3;

const FOLLOWER = `
from mbrobot import *
setSpeed(40)
while True:
    left_bright = irLeft.read_digital()
    right_bright = irRight.read_digital()
    if not left_bright and not right_bright:
        forward()
    elif not left_bright:
        leftArc(0.06)
    elif not right_bright:
        rightArc(0.06)
`;
const V3_FOLLOWER = `
from mbrobot_plusV3 import *
setSpeed(40)
while True:
    if irL1.read_digital() == 0:
        leftArc(0.06)
    elif irR1.read_digital() == 0:
        rightArc(0.06)
    else:
        forward()
    delay(10)
`;
/** Asks for all cells as often as there is a new picture. */
const V3_LIDAR = `
from mbrobot_plusV3 import *
delay(3000)
setSpeed(40)
left()
while True:
    began = running_time()
    getDistanceGrid()
    delay(max(67 - (running_time() - began), 1))
`;
/** Turns towards the lighter side, and reads the board's level as well. */
const V3_SEEKER = `
from mbrobot_plusV3 import *
from microbit import display, i2c
setSpeed(40)
while True:
    i2c.write(0x10, bytes([78]))
    light = i2c.read(0x10, 4)
    display.read_light_level()
    if light[0] * 256 + light[1] > light[2] * 256 + light[3]:
        leftArc(0.1)
    else:
        rightArc(0.1)
    delay(20)
`;
/** The same, which also asks its colour sensor what lies under it. */
const COLOUR_SEEKER = V3_SEEKER.replace('import display, i2c', 'import display, i2c\nimport colour').replace(
  '    delay(20)',
  '    colour.name()\n    delay(20)',
);
const COUNTER = 'def count(n):\n    i = 0\n    while i < n: i += 1\ncount(10**9)\n';
/** Line 6, in the midst of the loop, never begins. */
const BRANCH =
  'def count(n):\n    i = 0\n    while i < n:\n        i += 1\n        if i < 0:\n            i = 0\ncount(10**9)\n';

/** The most that recording may add, in percent. */
const MOST_COST = 5;
const WARM_US = 2_000_000;
const RECORDED_US = 60_000_000;
const RECORDING_ROUNDS = 5;

/** The subjects that need no browser. Measured in the project's folder after set-up. */
export const headlessSubjects: readonly Subject<undefined>[] = [
  speed('headless, line follower with delay(10)', { atLeast: 100, of: 'real time' }, () =>
    bestFactor(`${FOLLOWER}    delay(10)\n`, closedLine(), 120),
  ),
  speed('headless, line follower polling without a pause', { atLeast: 10, of: 'real time' }, () =>
    bestFactor(FOLLOWER, closedLine(), 20),
  ),
  speed(
    `headless, line follower with delay(10), ${FULL.objects} objects, ${FULL.points.toLocaleString('en')} stroke points`,
    { atLeast: 100, of: 'real time' },
    () => bestFactor(`${FOLLOWER}    delay(10)\n`, fullCourse(closedLine()), 60),
  ),
  speed('headless, V3 line follower with delay(10)', { atLeast: 250, of: 'real time' }, () =>
    bestOf(soloOf(V3_FOLLOWER, closedLine(), 'maqueen-plus-v3'), 120),
  ),
  speed('headless, V3 asking all 64 cells at 15 Hz', { atLeast: 100, of: 'real time' }, () =>
    bestOf(soloOf(V3_LIDAR, amongWalls(), 'maqueen-plus-v3'), 60),
  ),
  speed('headless, V3 seeking the light among ten lamps and walls', { atLeast: 150, of: 'real time' }, () =>
    bestOf(soloOf(V3_SEEKER, tenLamps(), 'maqueen-plus-v3'), 60),
  ),
  speed('headless, the same with a colour sensor over coloured sheets', { atLeast: 150, of: 'real time' }, () =>
    bestOf(soloOf(COLOUR_SEEKER, onSheets(tenLamps()), 'maqueen-plus-v3', { colour: 'tcs34725' }), 60),
  ),
  speed('headless, four Maqueen Lite on four lines', { atLeast: 30, of: 'real time' }, () => bestOf(onLines(4), 60)),
  speed('headless, eight Maqueen Lite on eight lines', { atLeast: 15, of: 'real time' }, () => bestOf(onLines(8), 30)),
  speed('headless, CPU-bound loop (while i<n: i+=1)', { atLeast: 15, of: 'the real board' }, () =>
    bestFactor(COUNTER, defaultScene(), 20),
  ),
  speed('headless, the same with a break point that never hits', { atLeast: 5, of: 'the real board' }, () =>
    bestOf(soloOf(BRANCH, defaultScene()), 5, (simulation) =>
      simulation.watch(atBreakPoints([{ file: 'main.py', line: 6 }]), 0),
    ),
  ),
  {
    budgets: [
      {
        what: 'recording of a run at full speed (line follower with delay(10))',
        budget: `<= ${MOST_COST} % of its time`,
      },
      { what: 'recording of a run in real time, all moments', budget: `<= ${MOST_COST} % of real time` },
    ],
    async measure() {
      return (await recordingPercents()).map((percent) => ({
        text: `${percent.toFixed(1)} %`,
        met: percent <= MOST_COST,
      }));
    },
  },
  checkSubject,
  checkMemorySubject,
  sweepSubject,
  tournamentSubject,
  {
    budgets: [{ what: 'CLI start to first output', budget: '<= 0.5 s' }],
    async measure() {
      const seconds = await startSeconds();
      return [{ text: `${seconds.toFixed(2)} s`, met: seconds <= 0.5 }];
    },
  },
];

function speed(
  what: string,
  { atLeast, of }: { readonly atLeast: number; readonly of: string },
  factor: () => Promise<number>,
): Subject<undefined> {
  return {
    budgets: [{ what, budget: `>= ${atLeast} x ${of}` }],
    async measure() {
      const reached = await factor();
      return [{ text: `${reached.toFixed(0)} x`, met: reached >= atLeast }];
    },
  };
}

const closedLine = (): Scene => sceneAt('courses/closed-line/scene.json');

function sceneAt(path: string): Scene {
  const parsed = parseScene(readFileSync(path, 'utf8'));
  if ('scene' in parsed) return parsed.scene;
  throw new Error(`${path}: ${parsed.problem}`);
}

/** Three walls and three blocks to look at. */
const amongWalls = (): Scene => sceneAt('courses/obstacles/scene.json');

/** The same in a dim room with ten lamps. */
function tenLamps(): Scene {
  const scene = amongWalls();
  const [width, height] = scene.size;
  const lamps = Array.from({ length: 10 }, (_, n): Lamp => {
    const at = [Math.round((((n % 5) + 0.5) * width) / 5), Math.round((n < 5 ? 0.25 : 0.75) * height)] as const;
    return { type: 'lamp', id: `lamp-${n}`, at, height: 260, brightness: 40 };
  });
  return { ...scene, ambient: 20, objects: [...scene.objects, ...lamps] };
}

/** The same with sheets of four colours side by side on the whole floor. */
function onSheets(scene: Scene): Scene {
  const [width, height] = scene.size;
  const sheets = (['red', 'yellow', 'green', 'blue'] as const).map((color, n): Paper => {
    const size = [Math.round(width / 4), height] as const;
    return {
      type: 'paper',
      id: `sheet-${n}`,
      at: [Math.round(((n + 0.5) * width) / 4), height / 2],
      size,
      angle: 0,
      color,
    };
  });
  return { ...scene, objects: [...sheets, ...scene.objects] };
}

/** Robots that each follow a line of their own. */
function onLines(count: number): RunSetup {
  const [width, height] = [700, 500];
  const cornerOf = (n: number) => [100 + (n % 4) * (width + 100), 100 + (n >> 2) * (height + 100)] as const;
  const lines = Array.from({ length: count }, (_, n): Stroke => {
    const [x, y] = cornerOf(n);
    const [right, top, cut] = [x + width, y + height, 120];
    const points = [
      [x + cut, y],
      [right - cut, y],
      [right, y + cut],
      [right, top - cut],
      [right - cut, top],
      [x + cut, top],
      [x, top - cut],
      [x, y + cut],
      [x + cut, y],
    ] as const;
    return { type: 'stroke', id: `line ${n}`, points, width: 20, color: 'black' };
  });
  const scene = { ...defaultScene(), size: [3300, 1300] as const, objects: lines };
  const robots = lines.map((_, n): DeviceSetup => {
    const [x, y] = cornerOf(n);
    const start = { type: null, at: [x + width / 2, y] as const, heading: 0, scale: 1, options: {} };
    const files = { 'main.py': `${FOLLOWER}    delay(10)\n` };
    return { name: `robot ${n}`, files, robot: 'maqueen-lite', board: 'auto', start };
  });
  return { scene, devices: robots as unknown as RunSetup['devices'], seed: 1, reality: 0 };
}

/** Simulated seconds per second of wall time. */
function bestFactor(program: string, scene: Scene, seconds: number): Promise<number> {
  return bestOf(soloOf(program, scene), seconds);
}

const soloOf = (program: string, scene: Scene, robot = 'auto', robotOptions: OptionValues = {}): RunSetup =>
  soloRun({ scene, files: { 'main.py': program }, robot, robotOptions, board: 'auto', seed: 1, reality: 0 });

/** @param prepare what is done to the run before */
async function bestOf(setup: RunSetup, seconds: number, prepare?: (simulation: Simulation) => void): Promise<number> {
  const firmware = new WebAssembly.Module(readFileSync('.cache/vm/vm.wasm'));
  let best = 0;
  for (let round = 0; round < ROUNDS; round++) {
    const simulation = await Simulation.create(setup, firmware);
    prepare?.(simulation);
    const startMs = performance.now();
    simulation.advanceTo(seconds * 1_000_000);
    const wallS = (performance.now() - startMs) / 1000;
    if (simulation.ended) throw new Error(`The program ended: ${simulation.takeConsole()}`);
    best = Math.max(best, seconds / wallS);
  }
  return best;
}

/**
 * Share of the tape in the time of a run as fast as possible, and share of all moments in real time. Processor time,
 * in turns: other work on the machine meets all of them.
 */
async function recordingPercents(): Promise<readonly number[]> {
  const firmware = new WebAssembly.Module(readFileSync('.cache/vm/vm.wasm'));
  const setup = soloOf(`${FOLLOWER}    delay(10)\n`, closedLine());
  const best = { plain: Infinity, thin: Infinity, whole: Infinity };
  for (let round = 0; round < RECORDING_ROUNDS; round++)
    for (const kind of ['plain', 'thin', 'whole'] as const) {
      let bytes = 0;
      const tape = new TapeBox((message) => (bytes += message.type === 'tape' ? message.piece.length : 0));
      const { moment, isMomentWanted } = tape;
      const run = await Simulation.create(setup, firmware, kind === 'plain' ? {} : { moment, isMomentWanted });
      tape.setThin(kind === 'thin');
      run.advanceTo(WARM_US);
      const before = process.cpuUsage();
      run.advanceTo(WARM_US + RECORDED_US);
      tape.tell();
      const { user, system } = process.cpuUsage(before);
      best[kind] = Math.min(best[kind], user + system);
      run.dispose();
      if (kind !== 'plain' && bytes === 0) throw new Error('Nothing was recorded.');
    }
  return [(100 * (best.thin - best.plain)) / best.plain, (100 * (best.whole - best.plain)) / RECORDED_US];
}

/** From the start of the process to the first thing that the program prints. */
async function startSeconds(): Promise<number> {
  if (!existsSync('dist/cli/main.mjs')) throw new Error('The command line is not built. Run: npm run setup');
  const folder = mkdtempSync(join(tmpdir(), 'parcours-bench-'));
  const program = join(folder, 'main.py');
  writeFileSync(program, "print('here')\n");
  let best = Infinity;
  for (let round = 0; round < ROUNDS; round++) {
    const startMs = performance.now();
    const child = spawn(process.execPath, ['bin/parcours.mjs', 'run', program], {
      stdio: ['ignore', 'pipe', 'inherit'],
    });
    const ended = new Promise((resolve) => child.on('close', resolve));
    await new Promise((resolve) => child.stdout.once('data', resolve));
    best = Math.min(best, (performance.now() - startMs) / 1000);
    await ended;
  }
  rmSync(folder, { recursive: true });
  return best;
}
