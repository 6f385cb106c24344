import { wrappedDeg } from '#core/angle';
import { START_SIDE_MM, startOutline } from '#scene/kinds/start';
import { robotColors, type Start } from '#scene/scene';
import { placeFields, robotColorField, robotNameField } from '../object-fields';
import { plus, toPoint, toVec, turned, turnedAbout } from '../plane';
import { hitWithin, mirroredDeg, mirroredPoint, scaledPoint, shifted, type EditorKind } from './kind';

const moved = (start: Start, dx: number, dy: number): Start => ({ ...start, at: shifted(start.at, dx, dy) });

/** Starts of further robots: moved and turned like a robot. */
export const start: EditorKind<Start> = {
  layer: 2,
  place: ({ at }) => at,
  span: () => null,
  middle: ({ at }) => toVec(at),
  extentMm: () => START_SIDE_MM,
  ...hitWithin<Start>(startOutline),
  moved,
  turned: (start, pivot, angleDeg) => ({
    ...start,
    at: toPoint(turnedAbout(toVec(start.at), pivot, angleDeg)),
    heading: wrappedDeg(start.heading + angleDeg),
  }),
  mirrored: (start, axis, atMm) => ({
    ...start,
    at: mirroredPoint(start.at, axis, atMm),
    heading: mirroredDeg(start.heading, axis),
  }),
  scaled: (start, about, factor) => ({ ...start, at: scaledPoint(start.at, about, factor) }),
  handles: ({ id, at, heading }, reachMm) => [
    { kind: 'rotate', at: plus(toVec(at), turned({ x: START_SIDE_MM / 2 + 2 * reachMm, y: 0 }, heading)), id },
  ],
  fields: (start) => [
    ...placeFields(start, start.at, moved),
    {
      ...{ kind: 'number', name: 'heading', value: start.heading, min: -180, max: 180, step: 15, unit: 'deg' },
      with: (angleDeg: number) => ({ ...start, heading: wrappedDeg(angleDeg) }),
    },
    robotNameField(start.name, (name) => ({ ...start, name })),
    robotColorField(start.color, (color) => ({ ...start, color })),
  ],
  made: (id, at, { robot, objects }) => {
    // The second device's robot has the first start, and the second colour.
    const place = objects.filter(({ type }) => type === 'start').length + 1;
    const color = robotColors[place % robotColors.length] ?? null;
    return { type: 'start', id, at, heading: robot.heading, robot: null, options: {}, name: '', color };
  },
};
