import type { Rgb } from '#core/rgb';

interface Place {
  readonly x: number;
  readonly y: number;
}

/** Light that falls off softly from a centre; nothing when `alpha` is 0. */
export function drawGlow(
  context: CanvasRenderingContext2D,
  at: Place,
  radius: number,
  color: Rgb,
  alpha: number,
): void {
  if (alpha <= 0) return;
  const light = `${String(color[0])}, ${String(color[1])}, ${String(color[2])}`;
  const gradient = context.createRadialGradient(at.x, at.y, 0, at.x, at.y, radius);
  for (const [distance, share] of FALL_OFF)
    gradient.addColorStop(distance, `rgba(${light}, ${(alpha * share).toFixed(3)})`);
  context.fillStyle = gradient;
  context.beginPath();
  context.arc(at.x, at.y, radius, 0, 2 * Math.PI);
  context.fill();
}

/**
 * Returns a function that draws the light of a lamp of one colour. It is painted once, since gradients cost most of
 * drawing a robot.
 */
export function glowOf(
  color: Rgb,
): (context: CanvasRenderingContext2D, at: Place, radius: number, alpha: number) => void {
  let kept: HTMLCanvasElement | null = null;
  return (context, at, radius, alpha) => {
    kept ??= paintedGlow(color);
    context.globalAlpha = alpha;
    context.drawImage(kept, at.x - radius, at.y - radius, 2 * radius, 2 * radius);
    context.globalAlpha = 1;
  };
}

function paintedGlow(color: Rgb): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 2 * GLOW_PX;
  const context = canvas.getContext('2d');
  if (context !== null) drawGlow(context, { x: GLOW_PX, y: GLOW_PX }, GLOW_PX, color, 1);
  return canvas;
}
/** Radius of the painted picture in px: it is soft, so that it can be stretched. */
const GLOW_PX = 48;

/** Roughly a bell curve: distance from the centre, share of the light. */
const FALL_OFF = [
  [0, 1],
  [0.3, 0.86],
  [0.5, 0.55],
  [0.7, 0.24],
  [0.85, 0.08],
  [1, 0],
] as const;

/**
 * The look of a light of this colour on a light floor: its hue at full strength, and an alpha that follows its
 * brightness. White, which a white floor would swallow, gets a touch of blue.
 */
export function floorLight(color: Rgb): { color: Rgb; alpha: number } {
  const brightest = Math.max(color[0], color[1], color[2]);
  if (brightest <= 0) return { color: [0, 0, 0], alpha: 0 };
  const full: Rgb = [scale(color[0]), scale(color[1]), scale(color[2])];
  const white = Math.min(...full) / 255;
  const tinted: Rgb = [mix(full[0], 150), mix(full[1], 200), full[2]];
  // The eye sees a tenth of the power as a third of the brightness, hence the root (chosen: 0.55).
  return { color: tinted, alpha: 0.92 * (Math.min(255, brightest) / 255) ** 0.55 };

  function scale(channel: number): number {
    return Math.round((Math.max(0, channel) / brightest) * 255);
  }
  function mix(channel: number, floor: number): number {
    return Math.round(channel + (Math.min(channel, floor) - channel) * white * white);
  }
}
