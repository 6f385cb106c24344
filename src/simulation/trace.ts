import { sha256 } from '@noble/hashes/sha2.js';
import { hexOf } from '#core/hex';

/** Simulated time between two rows of the trace, in µs. */
export const TRACE_PERIOD_US = 20_000;

/** Position and actions of a robot at one moment. */
export interface TraceRow {
  /** Name of its device. */
  readonly device: string;
  readonly timeUs: number;
  readonly xMm: number;
  readonly yMm: number;
  /** Counter-clockwise from +x, not wrapped. */
  readonly headingRad: number;
  /** Speed of each wheel's rim, forward positive; a slipping wheel moves over the floor at another speed. */
  readonly leftMmPerS: number;
  readonly rightMmPerS: number;
  /** −1 … 1. */
  readonly leftDuty: number;
  readonly rightDuty: number;
  readonly lineSensors: readonly { readonly name: string; readonly bright: boolean }[];
  /** Reading of the ultrasonic sensor; `null` if nothing is in range or there is no such sensor. */
  readonly distanceMm: number | null;
  /** Since the start. */
  readonly collisions: number;
}

/** Bytes of one row in the hash: time in ms, x, y in mm and heading in rad as little-endian doubles, in this order. */
const ROW_BYTES = 32;

/**
 * The fingerprint of a trajectory: SHA-256 over one row of 32 bytes per 20 ms of simulated time and robot, beginning with
 * time 0, several robots in the order of their devices: time in ms, x in mm, y in mm and heading in rad as little-endian IEEE doubles, no negative zeros. Two runs with the same
 * fingerprint were the same to the last bit. Without a robot there are no rows.
 */
export function createTraceHash(): {
  add(timeUs: number, xMm: number, yMm: number, headingRad: number): void;
  /** 64 hexadecimal digits; more rows may follow. */
  hex(): string;
} {
  const hash = sha256.create();
  const row = new Uint8Array(ROW_BYTES);
  const view = new DataView(row.buffer);
  return {
    add(timeUs, xMm, yMm, headingRad) {
      // Adding 0 turns a negative zero into a positive one.
      view.setFloat64(0, timeUs / 1000 + 0, true);
      view.setFloat64(8, xMm + 0, true);
      view.setFloat64(16, yMm + 0, true);
      view.setFloat64(24, headingRad + 0, true);
      hash.update(row);
    },
    hex: () => hexOf(hash.clone().digest()),
  };
}
