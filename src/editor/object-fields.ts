import { wrappedDeg } from '#core/angle';
import { boundsOf } from '#scene/kinds/index';
import type { PaintColor } from '#scene/paint/paint';
import {
  robotColors,
  sceneLimits,
  type LampColor,
  type Point,
  type RobotColor,
  type RobotStart,
  type Scene,
  type SceneObject,
} from '#scene/scene';
import { heightOf, withHeight, type StandingObject } from '#scene/kinds/heights';
import type { MoverWay } from '#scene/kinds/mover-way';
import type { ShapeName } from '#scene/shape/shape';
import type { SwitchPin, SwitchWay } from '#scene/kinds/switching';
import { within } from './plane';

/**
 * A number of an object that can be typed in. `x` and `y`: its place, of a line its start; `endX`, `endY`: its end. `length` and
 * `breadth`: its extent from above; `radius`: of a line's corners;
 * `side`: of a tag's square; `height`: its top above the floor.
 */
export type NumberName =
  | 'x'
  | 'y'
  | 'endX'
  | 'endY'
  | 'length'
  | 'breadth'
  | 'height'
  | 'turn'
  | 'thickness'
  | 'penWidth'
  | 'radius'
  | 'number'
  | 'side'
  | 'blocks'
  | 'speed'
  | 'spin'
  | 'phase'
  | 'reach'
  | 'letterHeight'
  | 'brightness'
  | 'onSeconds'
  | 'offSeconds'
  | 'mass'
  | 'friction'
  | 'heading'
  | 'scale';

/** Name of something about an object that can be changed. */
export type FieldName =
  | NumberName
  | (
      | 'shape'
      | 'spiked'
      | 'rolls'
      | 'flat'
      | 'color'
      | 'blockColor'
      | 'robotColor'
      | 'lampColor'
      | 'text'
      | 'name'
      | 'type'
      | 'way'
    )
  | ('switching' | 'onText' | 'offText' | 'switchButton' | 'switchPin');

/** The value of a field. */
export type FieldValue = number | boolean | string;

/**
 * Something about a `T` that can be changed in a list: a number with its range, a switch, a choice or words. `with`
 * gives the `T` with a value that fits; `null`: the value makes no sense there.
 */
export type Field<T = unknown> = { with(value: FieldValue, scene: Scene): T | null } & (
  | {
      readonly kind: 'number';
      readonly name: NumberName;
      readonly value: number;
      readonly min: number;
      readonly max: number;
      readonly step: number;
      readonly unit: 'mm' | 'deg' | 'mm/s' | 'deg/s' | 's' | 'cd' | 'g' | 'ratio' | 'times' | 'count';
    }
  | { readonly kind: 'switch'; readonly name: 'spiked' | 'rolls' | 'flat'; readonly value: boolean }
  | {
      readonly kind: 'choice';
      readonly name: 'color';
      readonly value: PaintColor;
      readonly choices: readonly PaintColor[];
    }
  | {
      readonly kind: 'choice';
      readonly name: 'blockColor';
      readonly value: PaintColor | 'any';
      readonly choices: readonly (PaintColor | 'any')[];
    }
  | {
      readonly kind: 'choice';
      readonly name: 'robotColor';
      /** `auto`: by the place of its device. */
      readonly value: RobotColor | 'auto';
      readonly choices: readonly (RobotColor | 'auto')[];
    }
  | {
      readonly kind: 'choice';
      readonly name: 'shape';
      readonly value: ShapeName;
      readonly choices: readonly ShapeName[];
    }
  | {
      readonly kind: 'choice';
      readonly name: 'type';
      readonly value: SceneObject['type'];
      readonly choices: readonly SceneObject['type'][];
    }
  | {
      readonly kind: 'choice';
      readonly name: 'way';
      readonly value: MoverWay;
      readonly choices: readonly MoverWay[];
    }
  | {
      readonly kind: 'choice';
      readonly name: 'lampColor';
      readonly value: LampColor | 'warm';
      readonly choices: readonly (LampColor | 'warm')[];
    }
  | {
      readonly kind: 'choice';
      readonly name: 'switching';
      readonly value: SwitchWay | 'always';
      readonly choices: readonly (SwitchWay | 'always')[];
    }
  | {
      readonly kind: 'choice';
      readonly name: 'switchButton';
      readonly value: 'a' | 'b';
      readonly choices: readonly ('a' | 'b')[];
    }
  | {
      readonly kind: 'choice';
      readonly name: 'switchPin';
      readonly value: SwitchPin;
      readonly choices: readonly SwitchPin[];
    }
  | {
      readonly kind: 'text';
      readonly name: 'text' | 'name' | 'onText' | 'offText';
      readonly value: string;
      readonly maxCharacters: number;
    }
);

type Range = { readonly min: number; readonly max: number };

/** A field for a length or a place in mm. */
export const lengthField = <T>(
  name: NumberName,
  value: number,
  range: Range,
  step: number,
  withValue: (mm: number) => T | null,
): Field<T> => ({ kind: 'number', name, value, ...range, step, unit: 'mm', with: withValue });

/** The field of the top of a thing above the floor; the usual height of its kind is left out again. */
export const heightField = <O extends StandingObject>(object: O): Field<O> =>
  lengthField('height', heightOf(object), sceneLimits.heightMm, 5, (mm) => withHeight(object, mm));

/** A field for how many, or which one. */
export const countField = <T>(
  name: 'number' | 'blocks',
  value: number,
  range: Range,
  withValue: (count: number) => T,
): Field<T> => ({ kind: 'number', name, value, ...range, step: 1, unit: 'count', with: withValue });

/** The two fields of a place. */
export function pointFields<T>(
  [x, y]: Point,
  withPoint: (to: Point) => T | null,
  [nameX, nameY]: readonly ['x', 'y'] | readonly ['endX', 'endY'] = ['x', 'y'],
): readonly Field<T>[] {
  return [
    lengthField(nameX, x, sceneLimits.placeMm, 10, (mm) => withPoint([mm, y])),
    lengthField(nameY, y, sceneLimits.placeMm, 10, (mm) => withPoint([x, mm])),
  ];
}

/** The fields of the ends of a line. */
export const endFields = <T>(
  from: Point,
  to: Point,
  withEnds: (from: Point, to: Point) => T | null,
): readonly Field<T>[] => [
  ...pointFields(from, (start) => withEnds(start, to)),
  ...pointFields(to, (end) => withEnds(from, end), ['endX', 'endY']),
];

/** The field of a rotation. */
export const turnField = <T extends { readonly angle: number }>(object: T): Field<T> => ({
  ...{ kind: 'number', name: 'turn', value: object.angle, ...sceneLimits.angleDeg, step: 15, unit: 'deg' },
  with: (angleDeg: number) => ({ ...object, angle: angleDeg }),
});

/** The field of the kind of something that can become another kind. */
export const typeField = <T, K extends SceneObject['type']>(
  value: K,
  choices: readonly K[],
  withType: (type: K, scene: Scene) => T | null,
): Field<T> => ({ kind: 'choice', name: 'type', value, choices, with: withType });

/** The place fields of a thing that moves as a whole: no part of it may exceed the limits of a course. */
export const placeFields = <O extends SceneObject>(
  object: O,
  at: Point,
  move: (object: O, dx: number, dy: number) => O,
): readonly Field<O>[] =>
  pointFields(at, (to) => {
    const { minX, minY, maxX, maxY } = boundsOf(object);
    const { min, max } = sceneLimits.placeMm;
    const step = (by: number, low: number, high: number): number =>
      Math.round(within(by, { min: Math.min(0, Math.ceil(min - low)), max: Math.max(0, Math.floor(max - high)) })) + 0;
    const [dx, dy] = [step(to[0] - at[0], minX, maxX), step(to[1] - at[1], minY, maxY)];
    return dx === 0 && dy === 0 ? null : move(object, dx, dy);
  });

/** The properties of the robot's start that the editor changes. */
export type StartChanges = Partial<Pick<RobotStart, 'at' | 'heading' | 'scale' | 'name' | 'color'>>;

/** The fields of the robot's start; name and colour if it is one of several, or has either. */
export const robotFields = ({ robot, objects }: Scene): readonly Field<StartChanges>[] => [
  ...placingFields(robot),
  ...(objects.some(({ type }) => type === 'start') || robot.name !== undefined || robot.color !== undefined
    ? [
        robotNameField(robot.name ?? '', (name) => ({ name })),
        robotColorField(robot.color ?? null, (color) => ({ color })),
      ]
    : []),
];

/** The field of a robot's name. */
export const robotNameField = <T>(value: string, withName: (name: string) => T): Field<T> => ({
  ...{ kind: 'text', name: 'name', value, maxCharacters: sceneLimits.startNameCharacters },
  with: withName,
});

/** The field of a robot's colour. */
export const robotColorField = <T>(value: RobotColor | null, withColor: (color: RobotColor | null) => T): Field<T> => ({
  ...{ kind: 'choice', name: 'robotColor', value: value ?? 'auto', choices: ['auto', ...robotColors] },
  with: (color: 'auto' | RobotColor) => withColor(color === 'auto' ? null : color),
});

const placingFields = ({ at, heading, scale }: RobotStart): readonly Field<StartChanges>[] => [
  ...pointFields(at, (to) => ({ at: to })),
  {
    ...{ kind: 'number', name: 'heading', value: heading, min: -180, max: 180, step: 15, unit: 'deg' },
    with: (angleDeg: number) => ({ heading: wrappedDeg(angleDeg) }),
  },
  {
    ...{ kind: 'number', name: 'scale', value: scale, ...sceneLimits.scale, step: 0.25, unit: 'times' },
    with: (times: number) => ({ scale: times }),
  },
];
