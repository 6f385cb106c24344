import { addedTo, type Stop } from '#core/stop';
import type { FieldShape, FloorGrid, Shares, StrokeHandle, StrokeShape } from '../shapes';
import { createGround, type Ground } from './ground';

/** The floor as line sensors and colour sensors see it. */
export interface PaintedFloor extends Ground {
  /** Mean shares of red, green and blue light under a round spot, each 1 on bare floor. */
  sharesAt(x: number, y: number, radiusMm: number): Shares;
  /** Calls something each time before the floor changes. */
  beforePaint(act: () => void): Stop;
}

/** Something that was painted: on the ground of infrared, and on those of the colours once there are any. */
interface Layer {
  readonly on: (ground: Ground, channel: number | null) => StrokeHandle;
  readonly handles: StrokeHandle[];
  layer: number | null;
}

/**
 * The ground in infrared, and one more for each of red, green and blue: paint differs in each, and mixes by area in each.
 * These three are made when a colour sensor first looks: a run without one has the ground of infrared alone.
 */
export function createPaintedFloor(): PaintedFloor {
  const infrared = createGround();
  const painted = new Set<Layer>();
  let colors: readonly Ground[] = [];
  let picture: FloorGrid | null = null;
  const beforePaint = new Set<() => void>();
  const tell = (): void => beforePaint.forEach((act) => act());

  const put = (on: Layer['on']): StrokeHandle => {
    tell();
    const layer: Layer = { on, handles: [on(infrared, null)], layer: null };
    colors.forEach((ground, channel) => layer.handles.push(on(ground, channel)));
    painted.add(layer);
    return {
      setLayer: (at) => {
        tell();
        layer.layer = at;
        for (const handle of layer.handles) handle.setLayer(at);
      },
      remove: () => {
        tell();
        painted.delete(layer);
        for (const handle of layer.handles.splice(0)) handle.remove();
      },
    };
  };
  const withColors = (): readonly Ground[] => {
    if (colors.length > 0) return colors;
    colors = [0, 1, 2].map((channel) => {
      const ground = createGround();
      for (const layer of painted) {
        const handle = layer.on(ground, channel);
        if (layer.layer !== null) handle.setLayer(layer.layer);
        layer.handles.push(handle);
      }
      ground.setFloor(picture);
      return ground;
    });
    return colors;
  };
  return {
    addStroke: (stroke) => put((ground, channel) => ground.addStroke(seenIn(stroke, channel))),
    addField: (field) => put((ground, channel) => ground.addField(seenIn(field, channel))),
    setFloor(grid) {
      tell();
      picture = grid;
      for (const ground of [infrared, ...colors]) ground.setFloor(grid);
    },
    beforePaint: (act) => addedTo(beforePaint, act),
    reflectanceAt: (x, y, radiusMm) => infrared.reflectanceAt(x, y, radiusMm),
    sharesAt(x, y, radiusMm) {
      const [red = 1, green = 1, blue = 1] = withColors().map((ground) => ground.reflectanceAt(x, y, radiusMm));
      return [red, green, blue];
    },
  };
}

/** Paint as one colour sees it; `null`: infrared. Paint without a colour is grey, as dark as in infrared. */
const seenIn = <P extends StrokeShape | FieldShape>(paint: P, channel: number | null): P => ({
  ...paint,
  reflectance: channel === null ? paint.reflectance : (paint.shares?.[channel] ?? paint.reflectance),
});
