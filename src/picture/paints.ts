import type { PaintColor } from '#scene/paint/paint';

/** A colour as it is painted on fields and things, and a dark ink of the same hue for their frames, signs and words. */
export interface PaintLook {
  readonly fill: string;
  readonly ink: string;
}

/**
 * The colours of painted fields and things; the same in both themes, because they are facts of the course. Every ink has a
 * contrast of 4.5:1 at least to its fill.
 */
export const paints: Readonly<Record<PaintColor, PaintLook>> = {
  red: { fill: '#EC5A5E', ink: '#4A070A' },
  orange: { fill: '#F08C2E', ink: '#4E2500' },
  yellow: { fill: '#F6CF3C', ink: '#4A3700' },
  green: { fill: '#4FB06D', ink: '#06301A' },
  blue: { fill: '#4C8FE0', ink: '#06244D' },
  purple: { fill: '#A66BD0', ink: '#260A3C' },
  gray: { fill: '#9AA2AB', ink: '#1B1F24' },
  black: { fill: '#23272D', ink: '#D6DBE1' },
  white: { fill: '#FFFFFF', ink: '#2A3038' },
  brown: { fill: '#B07C4C', ink: '#2B1502' },
  silver: { fill: '#CBD3DB', ink: '#2A3038' },
};
