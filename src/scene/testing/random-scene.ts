import { exactCos, exactSin } from '#core/exact-math';
import type { Rng } from '#core/rng';
import { freeId, type SceneEdit } from '../edit';
import type { StandingObject } from '../kinds/heights';
import { paintColors, type Painted } from '../paint/paint';
import {
  lampColors,
  robotColors,
  taskRules,
  type Block,
  type Lamp,
  type Mover,
  type Point,
  type Scene,
  type SceneObject,
  type TaskCard,
} from '../scene';
import { switchPins, type Switching } from '../kinds/switching';
import { inPercent, oneOf, wholeFrom } from './fuzz';

const point = (rng: Rng): Point => [wholeFrom(rng, -200, 1400), wholeFrom(rng, -200, 1100)];
const size = (rng: Rng): Point => [wholeFrom(rng, 5, 300), wholeFrom(rng, 5, 300)];
const angle = (rng: Rng): number => (inPercent(rng, 50) ? 45 * wholeFrom(rng, 0, 7) : wholeFrom(rng, 0, 3599) / 10);
/** A star with some corners, which is concave as a rule. */
function corners(rng: Rng): readonly Point[] {
  const count = wholeFrom(rng, 3, 12);
  return Array.from({ length: count }, (_, index): Point => {
    const [far, rad] = [wholeFrom(rng, 100, 400), (index * 2 * Math.PI) / count];
    return [Math.round(far * exactCos(rad)) + 0, Math.round(far * exactSin(rad)) + 0];
  });
}
/** The properties that any object may have and mostly lacks. */
const common = (rng: Rng): Pick<SceneObject, 'lock' | 'group'> => ({
  ...(inPercent(rng, 10) ? { lock: true } : {}),
  ...(inPercent(rng, 10) ? { group: oneOf(rng, ['g', 'toString', '1']) } : {}),
});

/** The height that any thing may have of its own and mostly lacks. */
const height = (rng: Rng): Pick<StandingObject, 'height'> =>
  inPercent(rng, 20) ? { height: wholeFrom(rng, 5, 1000) } : {};

/** The paint that any field or thing may have and mostly lacks. */
const paint = (rng: Rng): Painted => ({
  ...(inPercent(rng, 20) ? { color: oneOf(rng, paintColors) } : {}),
  ...infrared(rng),
});
const infrared = (rng: Rng): Pick<Painted, 'infrared'> =>
  inPercent(rng, 20) ? { infrared: wholeFrom(rng, 0, 140) / 100 } : {};

/** An object of any kind with random figures, as a course may have it. */
export function randomObject(rng: Rng, id: string): SceneObject {
  const box = { id, at: point(rng), size: size(rng), angle: angle(rng) };
  const polygon = inPercent(rng, 20) ? { corners: corners(rng), size: [200, 300] as Point } : {};
  const round = inPercent(rng, 20) ? ({ round: true } as const) : {};
  const body = { ...box, ...(inPercent(rng, 50) ? polygon : round) };
  const zone = { ...box, ...polygon, round: !('corners' in polygon) && inPercent(rng, 50), number: 0, blocks: 0 };
  const from = point(rng);
  const makers: readonly (() => SceneObject)[] = [
    () => ({
      type: 'wall',
      id,
      from,
      to: [from[0] + 10, from[1] - wholeFrom(rng, 0, 99)],
      thickness: wholeFrom(rng, 2, 500),
      ...height(rng),
      ...paint(rng),
    }),
    () => ({ type: 'block', ...body, ...height(rng), ...paint(rng), ...motion(rng, 'round' in body) }),
    () => ({ type: 'fixed-block', ...body, ...height(rng), ...paint(rng) }),
    () => randomLamp(rng, id),
    () => ({
      ...{ type: 'barrier', id, from, to: [from[0] - 1, from[1]], thickness: wholeFrom(rng, 2, 500) },
      ...{ ...height(rng), opens: switching(rng) },
    }),
    () => ({ type: 'tunnel', ...body }),
    () => ({
      ...{
        type: 'tag',
        id,
        at: point(rng),
        number: wholeFrom(rng, 1, 99),
        side: wholeFrom(rng, 10, 300),
        angle: angle(rng),
      },
      ...(inPercent(rng, 50) ? { flat: true } : {}),
    }),
    () => ({ type: 'spikes', ...body, ...height(rng) }),
    () => ({ type: 'paper', ...body, color: oneOf(rng, paintColors), ...infrared(rng) }),
    () => ({
      ...{ type: 'stroke', id, width: wholeFrom(rng, 1, 500), color: oneOf(rng, paintColors), ...infrared(rng) },
      points: Array.from({ length: wholeFrom(rng, 1, 30) }, () => point(rng)),
    }),
    () => ({
      ...zone,
      ...paint(rng),
      type: 'target',
      blocks: wholeFrom(rng, 0, 50),
      blockColor: oneOf(rng, paintColors),
    }),
    () => ({ ...zone, type: 'checkpoint', number: wholeFrom(rng, 1, 99) }),
    () => ({ ...zone, ...paint(rng), type: 'forbidden' }),
    () => ({
      ...box,
      ...round,
      type: 'mover',
      to: point(rng),
      speed: wholeFrom(rng, 5, 500),
      spiked: inPercent(rng, 50),
      ...height(rng),
      ...(inPercent(rng, 60) ? foe(rng, box.at) : {}),
    }),
    () => ({
      ...{ type: 'label', id, at: point(rng), height: wholeFrom(rng, 5, 500), angle: angle(rng) },
      text: oneOf(rng, ['Start', 'Ziel ▸', '"', '\\', '🤖', '\ud800', '</script>']),
    }),
    () => ({
      ...{ type: 'start', id, at: point(rng), heading: wholeFrom(rng, -360, 360), options: {} },
      ...{ robot: oneOf(rng, [null, 'callibot', 'maqueen-lite']), name: oneOf(rng, ['', 'Ada', '«2»']) },
      color: oneOf(rng, [null, ...robotColors]),
    }),
  ];
  return { ...oneOf(rng, makers)(), ...common(rng) };
}

const randomLamp = (rng: Rng, id: string): Lamp => ({
  ...{ type: 'lamp', id, at: point(rng), height: wholeFrom(rng, 80, 3000), brightness: wholeFrom(rng, 1, 10_000) / 10 },
  ...(inPercent(rng, 50) ? { color: oneOf(rng, lampColors) } : {}),
  ...(inPercent(rng, 60) ? { on: switching(rng) } : {}),
});

const switching = (rng: Rng): Switching =>
  oneOf<Switching>(rng, [
    'hand',
    { time: [wholeFrom(rng, 1, 36_000) / 10, 0.1] },
    { radio: ['an', oneOf(rng, ['aus', '"', '🤖'])] },
    { button: oneOf(rng, ['a', 'b']) },
    { pin: oneOf(rng, switchPins) },
  ]);

/** How a block moves, which is mostly left out. */
const motion = (rng: Rng, isRound: boolean): Pick<Block, 'mass' | 'friction' | 'rolls'> => ({
  ...(inPercent(rng, 20) ? { mass: wholeFrom(rng, 1, 5000) } : {}),
  ...(inPercent(rng, 20) ? { friction: wholeFrom(rng, 0, 150) / 100 } : {}),
  ...(isRound && inPercent(rng, 50) ? { rolls: true } : {}),
});

/** Random properties of a mover beyond a path between two places. */
function foe(rng: Rng, at: Point): Partial<Mover> {
  const spin = wholeFrom(rng, -360, 360);
  const turning = spin === 0 ? {} : { spin };
  if (inPercent(rng, 40)) {
    const zone = inPercent(rng, 50) ? { zone: oneOf(rng, ['z', 'wall-1', 'gone']) } : {};
    return {
      ...turning,
      to: at,
      chases: { ...zone, ...(inPercent(rng, 50) ? { reach: wholeFrom(rng, 10, 20_000) } : {}) },
    };
  }
  const stops = Array.from({ length: wholeFrom(rng, 1, 5) }, () => point(rng));
  return {
    ...turning,
    ...(inPercent(rng, 70) ? { stops } : {}),
    ...(inPercent(rng, 50) ? { waits: [0, wholeFrom(rng, 1, 600) / 10] } : {}),
    ...(inPercent(rng, 50) ? { loops: true } : {}),
    ...(inPercent(rng, 50) ? { phase: wholeFrom(rng, 1, 36_000) / 10 } : {}),
  };
}

/** An edit that suits a course: what the tools, the lists and the dialogs may do to it. */
export function randomEdit(rng: Rng, scene: Scene, depth = 0): SceneEdit {
  const ids = scene.objects.map(({ id }) => id);
  const some = ids.filter(() => inPercent(rng, 20));
  switch (rng.u32() % (depth < 2 ? 8 : 7)) {
    case 0:
    case 1:
      return randomAdding(rng, scene);
    case 2:
      return { type: 'remove', ids: some };
    case 3:
    case 4:
      return { type: 'replace', changes: replacements(rng, scene, some) };
    case 5:
      return randomRobotEdit(rng);
    case 6:
      return inPercent(rng, 10) ? { type: 'clear' } : randomCourseEdit(rng);
    default:
      return { type: 'all', edits: [randomRobotEdit(rng), randomEdit(rng, scene, depth + 1), randomCourseEdit(rng)] };
  }
}

/** On top of the others, or somewhere among them. */
function randomAdding(rng: Rng, scene: Scene): SceneEdit {
  const objects = newObjects(rng, scene, wholeFrom(rng, 0, 3));
  const at = objects.map(() => wholeFrom(rng, 0, scene.objects.length + 2));
  return inPercent(rng, 70) ? { type: 'add', objects } : { type: 'add', objects, at };
}

function newObjects(rng: Rng, scene: Scene, count: number, taken: string[] = []): readonly SceneObject[] {
  return Array.from({ length: count }, () => {
    const id = freeId(scene, oneOf(rng, ['wall', 'x', 'é', 'toString']), taken);
    taken.push(id);
    return randomObject(rng, id);
  });
}

/** Each of the objects stays equal, is changed, becomes pieces or goes. */
function replacements(
  rng: Rng,
  scene: Scene,
  ids: readonly string[],
): Extract<SceneEdit, { type: 'replace' }>['changes'] {
  const taken: string[] = [];
  return ids.map((id) => {
    const own = scene.objects.filter((object) => object.id === id);
    const ways: readonly (() => readonly SceneObject[])[] = [
      () => structuredClone(own),
      () => [randomObject(rng, id)],
      () => [...own, ...newObjects(rng, scene, 2, taken)],
      () => [],
    ];
    return { id, by: oneOf(rng, ways)() };
  });
}

function randomRobotEdit(rng: Rng): SceneEdit {
  const { robot }: Extract<SceneEdit, { type: 'robot' }> = oneOf(rng, [
    { type: 'robot', robot: { at: point(rng) } },
    { type: 'robot', robot: { heading: wholeFrom(rng, -3600, 3600) / 10 } },
    { type: 'robot', robot: { scale: oneOf(rng, [0.5, 1, 1.1, 3]), type: oneOf(rng, [null, 'callibot']) } },
    { type: 'robot', robot: { options: { S1: oneOf(rng, ['claw', 'none']) } } },
    { type: 'robot', robot: { name: oneOf(rng, ['', 'Ada', '«2»']), color: oneOf(rng, [null, ...robotColors]) } },
    { type: 'robot', robot: {} },
  ]);
  return { type: 'robot', robot };
}

function randomCard(rng: Rng): TaskCard {
  const text = oneOf(rng, ['', '**a** `b`', '«é»\n\n- "x"']);
  const hints = text === '' ? [] : [text, ''];
  const translations = inPercent(rng, 50) ? [{ language: 'fr', title: text, text, hints }] : [];
  return { language: oneOf(rng, ['', 'de']), title: text, hints, translations, picture: '', solution: text === '' };
}

function randomCourseEdit(rng: Rng): SceneEdit {
  const { changes }: Extract<SceneEdit, { type: 'course' }> = oneOf(rng, [
    { type: 'course', changes: { name: oneOf(rng, ['', 'Slalom', '«é»\n"']) } },
    { type: 'course', changes: { size: [wholeFrom(rng, 200, 10_000), wholeFrom(rng, 200, 10_000)] } },
    { type: 'course', changes: { task: { seconds: oneOf(rng, [null, 1, 62.5]), noTouch: inPercent(rng, 50) } } },
    {
      type: 'course',
      changes: { background: { at: point(rng), size: [400, 300], cells: [4, 3], levels: 'AAAA', picture: '' } },
    },
    { type: 'course', changes: { background: null, description: 'x' } },
    {
      type: 'course',
      changes: {
        task: { seconds: 9, noTouch: true, allows: ['hand'], robots: oneOf(rng, taskRules), stars: [30, 20.5] },
      },
    },
    { type: 'course', changes: { task: { seconds: null, noTouch: false, card: randomCard(rng) } } },
  ]);
  return { type: 'course', changes };
}
