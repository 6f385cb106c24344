/** Projects that tests pack, mutate and read again. */
import { createRng, type Rng } from '#core/rng';
import type { MyRobot } from '#my-robot/my-robot';
import { isStanding } from '#scene/kinds/heights';
import { isZone } from '#scene/kinds/zone';
import { defaultScene, type Point, type Scene, type SceneObject } from '#scene/scene';

import { anyHardware, defaultProjectSettings, type Project } from '../project';
import { drawn, track } from './drawings';

/** Forty objects of all kinds except strokes, as a course would have them. */
export function fortyObjects(seed = 1): readonly SceneObject[] {
  const rng = createRng(seed).fork('objects');
  return Array.from({ length: 40 }, (_, index) => anObject(rng, index));
}

function anObject(rng: Rng, index: number): SceneObject {
  const pick = (max: number): number => Math.floor(rng.unit() * max);
  const number = Math.floor(index / 8) + 1;
  const at: Point = [10 * pick(200), 10 * pick(150)];
  const box = { at, size: [50, 50] as Point, angle: 45 * pick(8) };
  const zone = { ...box, size: [200, 200] as Point, angle: 0, round: index % 2 === 0, blocks: 0, number: 0 };
  switch (index % 8) {
    case 0:
    case 1:
    case 2:
      return {
        type: 'wall',
        id: `wall-${String(3 * number - 2 + (index % 8))}`,
        from: at,
        to: [at[0], at[1] + 10 * (1 + pick(60))],
        thickness: 10,
      };
    case 3:
      return { type: 'block', id: `block-${String(number)}`, ...box };
    case 4:
      return { type: 'fixed-block', id: `fixed-block-${String(number)}`, ...box };
    case 5:
      return { type: 'checkpoint', id: `checkpoint-${String(number)}`, ...zone, number };
    case 6:
      return { type: 'target', id: `target-${String(number)}`, ...zone, blocks: pick(3) };
    default:
      return { type: 'spikes', id: `spikes-${String(number)}`, ...box };
  }
}

/** A program of forty lines as a pupil writes it. */
export const FORTY_LINES = `# Linienfolger mit Ultraschall
from microbit import *
from mbrobot import *

TEMPO = 35
ABSTAND = 15
runden = 0

def linie_folgen():
    links = irLeft.read_digital()
    rechts = irRight.read_digital()
    if links == 0 and rechts == 0:
        forward()
    elif links == 0:
        leftArc(0.1)
    elif rechts == 0:
        rightArc(0.1)
    else:
        suchen()

def suchen():
    # Die Linie ist weg: langsam drehen, bis sie wieder da ist
    left()
    while irLeft.read_digital() == 1 and irRight.read_digital() == 1:
        delay(10)
    forward()

def ausweichen():
    global runden
    runden = runden + 1
    stop()
    display.show(runden)
    backward()
    delay(400)
    right()
    delay(550)
    forward()

setSpeed(TEMPO)
display.show(Image.HAPPY)
while True:
    if getDistance() < ABSTAND:
        ausweichen()
    linie_folgen()
    delay(20)
`;

/** A course with a pen track, forty objects and a program of forty lines. */
export function largeProject(seed = 1): Project {
  const scene: Scene = {
    ...defaultScene(),
    name: 'Meine Strecke',
    size: [2000, 1500],
    objects: [...drawn(track, seed), ...fortyObjects(seed)],
  };
  return { files: [{ name: 'main.py', text: FORTY_LINES }], scene, course: null, settings: defaultProjectSettings };
}

/** A project with one of everything: all types of objects, all options, several files, a background. */
export function fullProject(): Project {
  const box = { at: [300, 400], size: [60, 45], angle: 135 } as const;
  const zone = { ...box, round: true, blocks: 0, number: 0 };
  const objects: readonly SceneObject[] = [
    { type: 'wall', id: 'a1', from: [-20, 35], to: [700, 35], thickness: 12 },
    { type: 'block', id: 'block-7', ...box },
    { type: 'fixed-block', id: 'block-2', ...box, angle: 0 },
    { type: 'stroke', id: 'Linie', points: [[0, 0], [10, -5], [10, 40], [-400, 41], [-400, 41]], width: 15, color: 'blue' }, // prettier-ignore
    { type: 'stroke', id: 'stroke-007', points: [[33, 44]], width: 30, color: 'white' },
    { type: 'target', id: 'target-1', ...zone, blocks: 2 },
    { type: 'checkpoint', id: 'checkpoint-99', ...zone, round: false, number: 99 },
    { type: 'forbidden', id: 'ä', ...zone },
    { type: 'spikes', id: 's', ...box },
    { type: 'mover', id: 'm1', ...box, to: [900, 400], speed: 120, spiked: true },
    { type: 'label', id: 'l', at: [600, 800], text: 'Grüezi 👋', height: 40, angle: 270 },
  ];
  const scene: Scene = {
    name: 'Alles «drin»',
    description: 'Zwei\nZeilen',
    size: [1234, 5678],
    board: 'calliope-mini-3',
    robot: { type: 'callibot', at: [617, 99], heading: 12.345, scale: 1.1, options: { sonar: 'left', lamp: 'none' } },
    task: { seconds: 90, noTouch: true },
    background: {
      at: [-10, 20],
      size: [1000, 700],
      cells: [2, 2],
      levels: 'Y2RgAAA=',
      picture: 'data:image/png;base64,iVBORw0KGgo=',
    },
    objects,
  };
  const settings = {
    device: 'calliope-mini-2',
    firmware: 'v2.1.2',
    robot: 'callibot',
    robotOptions: { callibot: { sonar: 'right' }, 'maqueen-lite': { echo: 'real', lamp: 'on' } },
    reality: 0.37,
    seed: 4711,
    arenaSenses: true,
  };
  const files = [
    { name: 'main.py', text: 'import fahren\n\nprint("Grüezi 👋 \u0000 \ud800")\n' },
    { name: 'fahren.py', text: '' },
    { name: 'daten.txt', text: '1;2;3\r\n' },
  ];
  return { files, scene, course: null, settings };
}

/** A project whose task has everything: rules, allowances, stars and a card in two languages. */
export function taskProject(): Project {
  const scene: Scene = {
    ...defaultScene(),
    name: 'Parkieren',
    description: 'Fahr ins **grüne** Feld.\n\n- ohne die Wand\n- ohne Hilfe',
    task: {
      seconds: 60,
      noTouch: true,
      allows: ['edits'],
      stars: [30, 20.5],
      card: {
        language: 'de',
        title: 'Rückwärts einparken',
        hints: ['Wie weit ist es?', '`backward()` fährt rückwärts.'],
        translations: [{ language: 'fr', title: 'Se garer', text: 'Va dans le **champ** vert.', hints: ['Recule.'] }],
        picture: 'data:image/png;base64,iVBORw0KGgo=',
        solution: true,
      },
    },
    objects: [{ type: 'target', id: 't', at: [900, 450], size: [200, 200], angle: 0, round: false, number: 0, blocks: 0 }], // prettier-ignore
  };
  return { files: [{ name: 'main.py', text: 'print("los")\n' }], scene, course: null };
}

/** A project with the pupil's own robot. */
export function measuredProject(): Project {
  const myRobot: MyRobot = {
    name: 'Roboter 3',
    robot: 'maqueen-plus-v2',
    used: true,
    measured: {
      drives: { slow: { aheadMm: 384, leftMm: -55 }, usual: { aheadMm: 265.5, leftMm: -23 }, fast: null },
      turnDeg: 372,
      echoesMm: [106, null],
      line: { L1: { black: 98, floor: 212 } },
    },
    traits: {
      motors: { difference: 0.046741, charge: 0.990759, sag: 0.046633, friction: -0.00042 },
      ultrasonic: { offsetMm: 4.2, scale: 1.002 },
      line: { L1: { black: 98, floor: 212 } },
    },
  };
  const settings = { ...defaultProjectSettings, robot: 'maqueen-plus-v2', myRobot };
  return {
    files: [{ name: 'main.py', text: 'from mbrobot_plusV2 import *\nforward()\n' }],
    scene: defaultScene(),
    course: null,
    settings,
  };
}

/** Three devices, and two starts among the things of the course. */
export function startsProject(): Project {
  const project = devicesProject();
  const { scene } = project;
  const second = { type: 'start', id: 'r2', at: [300, 200], heading: -45.5, robot: 'callibot' } as const;
  const third = { type: 'start', id: 'start-3', at: [300, 800], heading: 0, robot: null } as const;
  const objects = [
    { ...second, options: { S1: 'claw' }, name: 'Ärzt «2»', color: 'teal' as const },
    ...scene.objects,
    { ...third, options: {}, name: '', color: null },
  ];
  return { ...project, scene: { ...scene, task: { ...scene.task, robots: 'catch' }, objects } };
}

/** The project of `startsProject` with any angle, round bodies, polygons, locks and groups in its course. */
export function shapesProject(): Project {
  const project = startsProject();
  const said = [
    { angle: 12.5, lock: true },
    { angle: 359.9, round: true, group: 'g1' },
    { corners: [[0, 0], [80, 0], [20, 20], [-5, 60]] as Point[], group: 'g1' }, // prettier-ignore
  ] as const;
  const blocks = said.map((one, index): SceneObject => {
    const box = { type: 'block', id: `rund-${String(index + 1)}`, at: [200 + 100 * index, 600] as Point } as const;
    return { ...box, size: [80, 60], angle: 0, ...one };
  });
  const locked = project.scene.objects.map((object) => (object.type === 'start' ? { ...object, lock: true as const } : object)); // prettier-ignore
  const plain = {
    type: 'mover',
    at: [500, 300],
    to: [500, 300],
    size: [60, 60],
    angle: 0,
    speed: 100,
    spiked: false,
  } as const;
  const foes: readonly SceneObject[] = [
    { ...plain, id: 'streife', stops: [[600, -20]], waits: [0, 0.5], loops: true, phase: 1.5, spin: -45 },
    { ...plain, id: 'wache', chases: { zone: 'a5', reach: 700 } },
    { ...plain, id: 'jagd', spin: 30, chases: {} },
  ];
  return { ...project, scene: { ...project.scene, objects: [...locked, ...blocks, ...foes] } };
}

/** A project with three devices: a robot, a board to hold in the hand, and one that runs the same program. */
export function devicesProject(): Project {
  const remote = [
    { name: 'main.py', text: 'import radio\nradio.on()\nradio.send("vor")\n' },
    { name: 'tasten.py', text: 'A = 1\n' },
  ];
  return {
    ...fullProject(),
    devices: {
      first: 'Roboter',
      others: [
        { ...anyHardware, name: 'Fernbedienung', device: 'microbit-v2', robot: 'none', files: remote, sameAs: '' },
        {
          ...anyHardware,
          name: 'Ärzt 2',
          robot: 'maqueen-lite',
          robotOptions: { 'maqueen-lite': { lamp: 'on' } },
          files: [],
          sameAs: 'Fernbedienung',
        },
      ],
    },
  };
}

/** The project of `shapesProject` in whose course every other thing that stands has a height of its own. */
export function heightsProject(): Project {
  const { scene, ...project } = shapesProject();
  const heights = [30, 5, 1000];
  const objects = scene.objects.map((object, index) =>
    isStanding(object) && index % 2 === 0 ? { ...object, height: heights[(index / 2) % 3] ?? 0 } : object,
  );
  return { ...project, scene: { ...scene, objects } };
}

/** The same with colours: sheets, painted fields and things, lines of new colours, infrared. */
export function coloursProject(): Project {
  const { scene, ...project } = heightsProject();
  const sheet = { type: 'paper', at: [300, 100], size: [110, 80], angle: 12.5, color: 'green' } as const;
  const [first, ...rest] = scene.objects.map((object, index): SceneObject => {
    if (object.type === 'stroke') return { ...object, color: 'orange', ...(index % 2 === 0 && { infrared: 0.5 }) };
    const isPaintable = isZone(object) || ['wall', 'block', 'fixed-block'].includes(object.type);
    return isPaintable && index % 3 !== 0 ? ({ ...object, color: 'purple', infrared: 0.4 } as SceneObject) : object;
  });
  const last = { ...sheet, id: 'paper-2', color: 'silver', round: true, infrared: 1.4 } as const;
  const objects = [...(first ? [first] : []), { ...sheet, id: 'paper-1' }, ...rest, last];
  return { ...project, scene: { ...scene, objects } };
}

/** A project with the data of a task for a class, and one that is handed in. */
export function classProject(): Project {
  const world = { id: 'links', start: { at: [200, 450], heading: 90 }, seed: 7, reality: 0.5 };
  const task = {
    version: 1,
    id: 'parkieren-7b',
    checks: [
      { type: 'goals', points: 2 },
      { type: 'calls', name: 'irLeft' },
    ],
    worlds: [world],
    solution: [{ name: 'main.py', text: 'print("Lösung")\n' }],
    locks: { hand: true, lines: [1] },
  };
  return { ...taskProject(), task };
}

/** A project that a pupil hands in. */
export function handedInProject(): Project {
  const said = { task: 'parkieren-7b', alias: 'Änni', verdict: 'passed', tries: 12, hash: '0a'.repeat(32) };
  return { ...taskProject(), handIn: { version: 1, ...said, remarks: ['hand'] } };
}
