import { shallowRef, watch, type ShallowRef } from 'vue';

import type { RunModel } from '../../../session/run/run-model';

/** Rim speeds in whole cm/s. */
export interface WheelSpeeds {
  readonly [side: string]: number;
  readonly left: number;
  readonly right: number;
}

/** Simulated time over which speeds are averaged, in µs: figures that change faster cannot be read. */
const WINDOW_US = 250_000;

/**
 * Speeds of the wheels, derived from their rotation; `null` before a run.
 *
 * @param radiiMm of the real robot's wheels
 */
export function useWheelSpeeds(
  run: RunModel,
  radiiMm: () => readonly number[],
): Readonly<ShallowRef<WheelSpeeds | null>> {
  const speeds = shallowRef<WheelSpeeds | null>(null);
  let since: { timeUs: number; turnRad: readonly [number, number] } | null = null;
  watch(run.shown, (snapshot) => {
    const robot = snapshot?.robot ?? null;
    if (snapshot === null || robot === null) {
      since = speeds.value = null;
      return;
    }
    const tookUs = since === null ? 0 : snapshot.timeUs - since.timeUs;
    if (since !== null && tookUs >= 0 && tookUs < WINDOW_US) return;
    const [left = 0, right = 0] = radiiMm().map((radiusMm) => radiusMm * robot.scale);
    if (since !== null && tookUs > 0) {
      const rate = (wheel: 0 | 1, radiusMm: number): number =>
        // rad · mm per µs, in cm/s; adding 0 turns -0 into 0
        Math.round((((robot.wheelTurnRad[wheel] - (since?.turnRad[wheel] ?? 0)) * radiusMm) / tookUs) * 1e5) + 0;
      speeds.value = { left: rate(0, left), right: rate(1, right) };
    }
    since = { timeUs: snapshot.timeUs, turnRad: robot.wheelTurnRad };
  });
  return speeds;
}
