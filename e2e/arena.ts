import type { Vec } from '../src/core/geometry';
import { fitView } from '../src/web/pupil/arena/view/view-transform';
import type { App, Place } from './app';
import type { Shown } from './page';

const ARENA = '[data-testid=arena]';

interface WithTrail {
  trail?: [number, number, number][];
}

/** Records the robot's path from now on; `trailOf` returns it. */
export const watchTrail = (app: App): Promise<void> =>
  app.evaluate((css) => {
    const arena = document.querySelector<HTMLElement>(css);
    if (arena === null) throw new Error('There is no arena.');
    const trail: [number, number, number][] = ((window as WithTrail).trail = []);
    const note = (): void => {
      const { xMm, yMm, headingDeg } = arena.dataset;
      trail.push([Number(xMm), Number(yMm), Number(headingDeg)]);
    };
    new MutationObserver(note).observe(arena, { attributeFilter: ['data-x-mm', 'data-y-mm', 'data-heading-deg'] });
    note();
  }, ARENA);

/** The robot's places since `watchTrail`, about ten times a second, the newest last. */
export async function trailOf(app: App): Promise<readonly Shown[]> {
  const trail = await app.evaluate(() => (window as WithTrail).trail ?? []);
  return trail.map(([xMm, yMm, headingDeg]) => ({ xMm, yMm, headingDeg }));
}

/** The robot's place to a tenth of a mm, as the arena writes it. */
export const robotAt = (app: App): Promise<Shown> =>
  app.evaluate((css) => {
    const { xMm, yMm, headingDeg } = document.querySelector<HTMLElement>(css)?.dataset ?? {};
    return { xMm: Number(xMm), yMm: Number(yMm), headingDeg: Number(headingDeg) };
  }, ARENA);

/** Pixels of one layer of the arena that nothing shines through, by their places in mm. Shadows and cones are no paint. */
export async function paintOf(
  app: App,
  layer: 'trail' | 'blocks' | 'moving',
  size: readonly [number, number],
): Promise<readonly Vec[]> {
  const found = await app.evaluate(
    ({ css, fromEnd }) => {
      const arena = document.querySelector<HTMLElement>(css);
      const canvases = Array.from(document.querySelectorAll<HTMLCanvasElement>(`${css} canvas`));
      const canvas = canvases[canvases.length - fromEnd];
      const context = canvas?.getContext('2d') ?? null;
      if (arena === null || canvas === undefined || context === null || canvas.width * canvas.height === 0) return null;
      const [host, own] = [arena.getBoundingClientRect(), canvas.getBoundingClientRect()];
      const pxPerPixel = own.width / canvas.width;
      const { data, width } = context.getImageData(0, 0, canvas.width, canvas.height);
      const points: [number, number][] = [];
      for (let at = 3; at < data.length; at += 4) {
        if ((data[at] ?? 0) < 250) continue;
        const pixel = (at - 3) / 4;
        points.push([
          own.left - host.left - arena.clientLeft + ((pixel % width) + 0.5) * pxPerPixel,
          own.top - host.top - arena.clientTop + (Math.floor(pixel / width) + 0.5) * pxPerPixel,
        ]);
      }
      return { points, widthPx: arena.clientWidth, heightPx: arena.clientHeight };
    },
    { css: ARENA, fromEnd: { moving: 1, blocks: 2, trail: 3 }[layer] },
  );
  if (found === null) return [];
  const { pxPerMm, leftPx, bottomPx } = fitView(size, found);
  return found.points.map(([x, y]) => ({ x: (x - leftPx) / pxPerMm, y: (bottomPx - y) / pxPerMm }));
}

/** The middle of what is painted. */
export const middleOf = (points: readonly Vec[]): Vec => ({
  x: points.reduce((sum, { x }) => sum + x, 0) / points.length,
  y: points.reduce((sum, { y }) => sum + y, 0) / points.length,
});

/** Places as the robot sees them: x ahead of its axle, y to its left. */
export function seenFrom({ xMm, yMm, headingDeg }: Shown, points: readonly Vec[]): readonly Vec[] {
  const heading = (headingDeg * Math.PI) / 180;
  const [cos, sin] = [Math.cos(heading), Math.sin(heading)];
  return points.map(({ x, y }) => ({
    x: (x - xMm) * cos + (y - yMm) * sin,
    y: (y - yMm) * cos - (x - xMm) * sin,
  }));
}

/** A place of the arena (mm) in the window, in CSS px, while the whole arena is shown. */
export async function inWindow(
  app: Pick<App, 'evaluate'>,
  size: readonly [number, number],
  places: readonly (readonly [xMm: number, yMm: number])[],
): Promise<Place[]> {
  const box = await app.evaluate((css) => {
    const arena = document.querySelector<HTMLElement>(css);
    if (arena === null) throw new Error('There is no arena.');
    const { left, top } = arena.getBoundingClientRect();
    return { left, top, widthPx: arena.clientWidth, heightPx: arena.clientHeight };
  }, ARENA);
  const { pxPerMm, leftPx, bottomPx } = fitView(size, box);
  return places.map(([x, y]) => ({ x: box.left + leftPx + x * pxPerMm, y: box.top + bottomPx - y * pxPerMm }));
}
