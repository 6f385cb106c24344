/** Drawings of 5,000 pen points that tests and benchmarks put into links: usual ones and frantic ones. */
import { exactCos, exactSin } from '#core/exact-math';
import type { Vec } from '#core/geometry';
import { createRng, type Rng } from '#core/rng';
import type { SceneObject } from '#scene/scene';
import { FINGER_TOLERANCE_MM, simplified, TOLERANCE_MM } from '#scene/simplify';

const TURN = 2 * Math.PI;
const POINTS = 5_000;

/** The lines of one drawing, each as the pen reported it, world mm. */
export type Drawing = readonly (readonly Vec[])[];

/** Three loops of about 13.4 m in all, jitter ±0.6 mm: a closed track. */
export function track(rng: Rng): Drawing {
  return [
    path(POINTS, (index) => {
      const angle = (index / POINTS) * 3 * TURN;
      const radius = 1 + 0.18 * exactSin(2.3 * angle) + 0.07 * exactCos(5.1 * angle);
      return shaken(rng, 1000 + 760 * radius * exactCos(angle), 750 + 560 * radius * exactSin(angle), 0.6);
    }),
  ];
}

/** A walk in steps of 3 mm that turns at random: a scribble of 15 m. */
const scribble = (rng: Rng): Drawing => [walk(rng, { step: 3, bend: 0.1, jitterMm: 0 })];

/** The same by a finger: its tremor, and whole pixels of 1.6 mm, as a small tablet reports them. */
const finger = (rng: Rng): Drawing =>
  [walk(rng, { step: 3, bend: 0.1, jitterMm: 1 }).map(({ x, y }) => ({ x: pixel(x), y: pixel(y) }))]; // prettier-ignore
const pixel = (mm: number): number => 1.6 * Math.round(mm / 1.6);

/** Fast and tight: 30 m with many small turns. */
const wild = (rng: Rng): Drawing => [walk(rng, { step: 6, bend: 0.35, jitterMm: 0.5 })];

/** Filling a field by going to and fro, 90 times over half a metre. */
const hatching = (rng: Rng): Drawing => [
  path(POINTS, (index) => {
    const share = (index / POINTS) * 90;
    const back = Math.floor(share) % 2 === 1;
    const along = share - Math.floor(share);
    return shaken(rng, 300 + 500 * (back ? 1 - along : along) + 20 * exactSin(share), 100 + 12 * share, 0.8);
  }),
];

/** A spiral of 24 rounds, 45 m. */
const spiral = (rng: Rng): Drawing => [
  path(POINTS, (index) => {
    const angle = (index / POINTS) * 24 * TURN;
    return shaken(rng, 1000 + 4 * angle * exactCos(angle), 750 + 4 * angle * exactSin(angle), 0.6);
  }),
];

/** Words of six letters of 40 to 80 mm, each letter a loop: as many as the arena has room for at five a line. */
function words(count: number): (rng: Rng) => Drawing {
  const points = POINTS / count;
  return (rng) =>
    Array.from({ length: count }, (_, word) => {
      const [left, base] = [100 + 360 * (word % 5), 1400 - 170 * Math.floor(word / 5)];
      let [height, lean] = [60, 0];
      return path(points, (index) => {
        const share = index / points;
        if (index % Math.floor(points / 6) === 0) [height, lean] = [40 + 40 * rng.unit(), 12 * (rng.unit() - 0.5)];
        const x = left + 275 * share + 16 * exactCos(6 * TURN * share) + lean;
        return shaken(rng, x, base + (height / 2) * exactSin(6 * TURN * share), 0.5);
      });
    });
}

/** Ten long lines of gentle bends across the arena. */
function tracks(rng: Rng): Drawing {
  return Array.from({ length: 10 }, (_, line) => {
    const [a, b, c] = [rng.unit() * TURN, rng.unit() * TURN, 1 + rng.unit()];
    return path(POINTS / 10, (index) => {
      const along = index / (POINTS / 10);
      const y = 75 + 145 * line + 60 * exactSin(a + c * TURN * along) + 25 * exactSin(b + 3 * c * TURN * along);
      return shaken(rng, 60 + 1880 * along, y, 0.6);
    });
  });
}

/** Usual drawings of a lesson; each must fit into a link of 2.7 kB with forty objects and a program. */
export const drawings: Readonly<Record<string, (rng: Rng) => Drawing>> = {
  track,
  tracks,
  scribble,
  finger,
  hatching,
  spiral,
  writing: words(10),
};

/** Drawings that nobody makes on purpose. */
export const wildDrawings: Readonly<Record<string, (rng: Rng) => Drawing>> = { wild, page: words(40) };

/** The drawing of a seed as the pen puts it into a course. */
export const drawn = (of: (rng: Rng) => Drawing, seed: number): readonly SceneObject[] =>
  of(createRng(seed).fork('drawing')).map((line, index) => ({
    type: 'stroke',
    id: `stroke-${String(index + 1)}`,
    points: simplified(line, of === finger ? FINGER_TOLERANCE_MM : TOLERANCE_MM),
    width: 20,
    color: 'black',
  }));

const path = (count: number, place: (index: number) => Vec): readonly Vec[] =>
  Array.from({ length: count }, (_, index) => place(index));

const shaken = (rng: Rng, x: number, y: number, mostMm: number): Vec => ({
  x: x + (2 * rng.unit() - 1) * mostMm,
  y: y + (2 * rng.unit() - 1) * mostMm,
});

interface Walk {
  readonly step: number;
  readonly bend: number;
  readonly jitterMm: number;
}

function walk(rng: Rng, { step, bend, jitterMm }: Walk): readonly Vec[] {
  let [x, y, heading, turn] = [1000, 750, 0, 0];
  return path(POINTS, () => {
    turn = 0.9 * turn + (rng.unit() - 0.5) * bend;
    heading += turn;
    x += step * exactCos(heading);
    y += step * exactSin(heading);
    if (x < 60 || x > 1940 || y < 60 || y > 1440) heading += 0.4;
    return shaken(rng, x, y, jitterMm);
  });
}
