// @vitest-environment happy-dom
import { expect, it, vi } from 'vitest';
import type { SceneObject } from '#scene/scene';
import { carriedTags, type CarriedTag } from '#scene/kinds/stuck-tags';
import { lightPalette } from '../model/palette';
import { createTagSprites } from './tag-sprites';

it('paints a tag on a block or moving obstacle again only where that has moved, and takes it away with it', () => {
  const block: SceneObject = { type: 'block', id: 'block', at: [200, 400], size: [50, 50], angle: 0 };
  const tagged: SceneObject = { type: 'tag', id: 'tagged', at: [175, 400], number: 8, side: 40, angle: 180 };
  const mover: SceneObject = { type: 'mover', id: 'mover', at: [900, 400], to: [1100, 400], size: [50, 50], angle: 0, speed: 100, spiked: false }; // prettier-ignore
  const tag: SceneObject = { type: 'tag', id: 'tag', at: [880, 400], number: 7, side: 40, angle: 180 };
  const host = document.body.appendChild(document.createElement('div'));
  const context = new Proxy({}, { get: () => () => undefined }) as CanvasRenderingContext2D;
  vi.spyOn(HTMLCanvasElement.prototype, 'getContext').mockReturnValue(context);
  const carriedTag = vi.fn();
  const view = { pxPerMm: 0.5, leftPx: 0, bottomPx: 450 };
  const frame = { ...{ view, ratio: 1, palette: lightPalette }, sight: { left: 0, top: 0, width: 600, height: 450 }, kinds: { carriedTag } }; // prettier-ignore
  const sprites = createTagSprites(() => host);
  sprites.prepare(carriedTags([mover, tag, block, tagged]), frame);
  const there = { xMm: 1000, yMm: 400, headingRad: 0 };
  for (const poses of [
    {},
    {},
    { mover: there },
    { mover: { ...there } },
    { mover: there, block: there },
    { mover: there, block: { ...there } },
  ])
    sprites.paint(poses);
  const painted = carriedTag.mock.calls.map(([, , one, pose]): unknown => [(one as CarriedTag).tag.id, pose]);
  expect(painted).toEqual([['tag', null], ['tagged', null], ['tag', there], ['tagged', there]]); // prettier-ignore
  expect(host.querySelectorAll('canvas')).toHaveLength(2);
  sprites.prepare([], frame);
  expect(host.querySelectorAll('canvas')).toHaveLength(0);
  vi.restoreAllMocks();
});
