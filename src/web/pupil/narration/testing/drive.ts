import type { RobotSnapshot } from '#simulation/snapshot';
import type { Verdict } from '#simulation/task/verdict';
import { defaultScene, type Scene, type SceneObject } from '#scene/scene';
import type { HuskyResult } from '#devices/huskylens';
import { bareState, type CameraState, type ColourState } from '#robots/robot';
import { lidarOf } from '#robots/testing/lidar-of';
import { maqueenLite } from '#robots/maqueen-lite/type';

import { pictureOf } from '../../../app/testing/run';
import { createNarrator } from '../narrator';

/** Differences from a Maqueen Lite at rest at x 20, y 45 cm that faces +x, with nothing around it. */
export interface Changes {
  readonly xMm?: number;
  readonly yMm?: number;
  readonly headingDeg?: number;
  readonly pathMm?: number;
  readonly turnedDeg?: number;
  /** `null`: nothing in range, `undefined`: no such sensor. */
  readonly aheadMm?: number | null | undefined;
  /** Depths in the row at eye level of a lidar that it has besides, from the left. */
  readonly lidarMm?: readonly (number | null)[];
  /** Its line sensors from left to right, 1 = dark. */
  readonly line?: readonly (0 | 1)[];
  /** The colour under a colour sensor that it has besides. */
  readonly colour?: ColourState['name'];
  /** The answer of a camera that it has besides: ids of blocks; `line`. */
  readonly camera?: readonly (number | 'line')[];
  readonly touches?: number;
  readonly verdict?: Partial<Verdict>;
  readonly timeUs?: number;
}

const open: Verdict = {
  ...{ state: 'open', atMs: null, reason: null, by: null, place: null, help: [], early: null, stars: null, touches: 0 },
  robots: [],
  checkpoints: { passed: 0, of: 0 },
  targets: { reached: 0, of: 0 },
  blocks: { delivered: 0, of: 0 },
};

const NAMES: Readonly<Record<number, readonly string[]>> = { 2: ['left', 'right'], 5: ['L2', 'L1', 'M', 'R1', 'R2'] };

const PAPER = { side: 'down', atMm: { x: 0, y: 0 }, raw: [0, 0, 0, 0], color: [0, 0, 0], hue: 0 } as const;
const CAMERA: CameraState = {
  ...{ fromMm: { x: 0, y: 0 }, headingRad: 0, endsMm: [], seen: null },
  algorithm: 'tag',
  sight: { nearMm: 0, nearSlope: 0, farMm: 0, farSlope: 0 },
};
const resultOf = (id: number | 'line'): HuskyResult =>
  id === 'line'
    ? { kind: 'arrow', tail: [160, 230], head: [160, 20], id: 1 }
    : { kind: 'block', x: 160, y: 120, width: 40, height: 40, id };

/** A robot as a run shows it. */
export function robotOf(changes: Changes): RobotSnapshot {
  const { xMm = 200, yMm = 450, headingDeg = 0, pathMm = 0, turnedDeg = 0, line = [0, 0], touches = 0, lidarMm } = changes; // prettier-ignore
  const aheadMm = 'aheadMm' in changes ? changes.aheadMm : null;
  const headingRad = (headingDeg * Math.PI) / 180;
  const hitMm = (mm: number) => ({ x: xMm + 58 + mm * Math.cos(headingRad), y: yMm + mm * Math.sin(headingRad) });
  const beam = { fromMm: { x: xMm + 58, y: yMm }, headingRad, openingRad: 0.5 };
  const ultrasonic =
    aheadMm === undefined ? null : { ...beam, distanceMm: aheadMm, hitMm: aheadMm === null ? null : hitMm(aheadMm) };
  return {
    ...{ type: 'maqueen-lite', scale: 1, wheelTurnRad: [0, 0] as const },
    ...{ pose: { xMm, yMm, headingRad }, collisions: touches, pathMm, turnedRad: (turnedDeg * Math.PI) / 180 },
    state: {
      ...bareState,
      lineSensors: line.map((dark, at) => ({
        name: NAMES[line.length]?.[at] ?? String(at),
        atMm: { x: 40, y: -at },
        bright: dark === 0,
      })),
      ultrasonic,
      ...(changes.colour && { colours: [{ ...PAPER, name: changes.colour }] }),
      ...(changes.camera && { camera: { ...CAMERA, seen: changes.camera.map(resultOf) } }),
      lidar: lidarMm === undefined ? null : { ...lidarOf({ row: lidarMm, headingRad }), fromMm: beam.fromMm },
    },
  };
}

/** The whole picture. */
export const seen = (changes: Changes) =>
  pictureOf({
    timeUs: changes.timeUs ?? 0,
    robot: robotOf(changes),
    verdict: changes.verdict === undefined ? null : { ...open, ...changes.verdict },
  });

/** A course with these things, of 1200 × 900 mm. */
export const courseWith = (...objects: readonly SceneObject[]): Scene => ({ ...defaultScene(), objects });

/**
 * The announcements of a drive: `[ms, differences from the start]` one after the other, each holding until the next.
 * Each sentence begins with its time in ms: `2000 Wand 12 cm voraus.`
 */
export function told(
  scene: Scene,
  drive: readonly (readonly [ms: number, changes: Changes])[],
  untilMs: number,
): readonly string[] {
  const narrator = createNarrator(() => ({ scene, body: maqueenLite.body.outlineMm }));
  const sentences: string[] = [];
  for (let nowMs = 0; nowMs <= untilMs; nowMs += 100) {
    const [, changes] = drive.filter(([ms]) => ms <= nowMs).at(-1) ?? [0, {}];
    narrator.see(seen(changes), nowMs);
    const words = narrator.next(nowMs);
    if (words !== null) sentences.push(`${String(nowMs)} ${words}`);
  }
  return sentences;
}
