/**
 * A car light of the Maqueen V5: a colour light that also flashes and changes its colour by itself. Here only its being
 * lit counts.
 *
 * Source: DFRobot pxt-maqueen `maqueen.ts`, namespace Maqueen_V5 (`setRgblLed`, `setRgbBlink`, `setRgbchange`). The
 * duration of a flash is not published: chosen.
 */
import type { Clock } from '#core/clock';

const LAST_COLOUR = 7; // 1 red … 7 white, 8 off: DFRobot, CarLightColors; 0 off: humpda/maqueenliteV5_micropython

/** Time from one flash to the next by grade, 1 slow … 5 fast: chosen. The light shines for half of it. */
const FLASH_US = [600_000, 600_000, 500_000, 400_000, 300_000, 200_000] as const;
const HALF = 0.5;

/** One light, as its controller sees it. */
export interface CarLight {
  /** Shines steadily: 1 … 7; every other number is off. */
  colour(colour: number): void;
  /** Rate of flashes: 1 … 5. */
  flashGrade(grade: number): void;
  /** Flashes this many times in its colour from now on and is then off; 0 makes it shine steadily. */
  flash(times: number): void;
  /** Runs through the colours from now on; 0 changes nothing. */
  change(grade: number): void;
  isLit(): boolean;
}

/** Makes a light that is off. */
export function createCarLight(clock: Clock): CarLight {
  let hasColour = false;
  let isChanging = false;
  let grade = 0;
  let flashes: { readonly sinceUs: number; readonly times: number } | null = null;
  return {
    colour: (colour) => {
      hasColour = colour >= 1 && colour <= LAST_COLOUR;
      isChanging = false;
      flashes = null;
    },
    flashGrade: (to) => {
      grade = to;
    },
    flash: (times) => {
      flashes = times === 0 ? null : { sinceUs: clock.nowUs, times };
    },
    change: (to) => {
      isChanging = to !== 0;
    },
    isLit: () => {
      if (isChanging) return true;
      if (flashes === null || !hasColour) return hasColour;
      const count = (clock.nowUs - flashes.sinceUs) / (FLASH_US[grade] ?? FLASH_US[0]);
      return count < flashes.times && count - Math.floor(count) < HALF;
    },
  };
}
