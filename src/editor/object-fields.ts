import {
  sceneLimits,
  strokeColors,
  type Label,
  type RobotStart,
  type SceneObject,
  type Stroke,
  type StrokeColor,
} from '#scene/scene';

/** A number of an object that can be typed in. `x` and `y` are its place (a line: its start), `endX` and `endY` its end. */
export type NumberName =
  | 'x'
  | 'y'
  | 'endX'
  | 'endY'
  | 'width'
  | 'height'
  | 'turn'
  | 'thickness'
  | 'penWidth'
  | 'number'
  | 'blocks'
  | 'speed'
  | 'letterHeight'
  | 'heading'
  | 'scale';

/** Name of something about an object that can be changed. */
export type FieldName = NumberName | 'round' | 'spiked' | 'color' | 'text' | 'type';

/** Something about an object that can be changed in a list: a number with its range, a switch, a choice or words. */
export type Field =
  | {
      readonly kind: 'number';
      readonly name: NumberName;
      readonly value: number;
      readonly min: number;
      readonly max: number;
      readonly step: number;
      readonly unit: 'mm' | 'deg' | 'mm/s' | 'times' | 'count';
    }
  | { readonly kind: 'switch'; readonly name: 'round' | 'spiked'; readonly value: boolean }
  | {
      readonly kind: 'choice';
      readonly name: 'color';
      readonly value: StrokeColor;
      readonly choices: readonly StrokeColor[];
    }
  | {
      readonly kind: 'choice';
      readonly name: 'type';
      readonly value: SceneObject['type'];
      readonly choices: readonly SceneObject['type'][];
    }
  | { readonly kind: 'text'; readonly name: 'text'; readonly value: string; readonly maxCharacters: number };

/** Kinds of blocks that can become each other. */
export const boxKinds = ['block', 'fixed-block', 'spikes'] as const;

/** Kinds of zones, which can become each other. */
export const zoneKinds = ['target', 'checkpoint', 'forbidden'] as const;

type Range = { readonly min: number; readonly max: number };

const lengthMm = (name: NumberName, value: number, range: Range, step = 10): Field => ({
  kind: 'number',
  name,
  value,
  ...range,
  step,
  unit: 'mm',
});

const place = (name: 'x' | 'y' | 'endX' | 'endY', value: number): Field => lengthMm(name, value, sceneLimits.placeMm);

const count = (name: 'number' | 'blocks', value: number, range: Range): Field => ({
  kind: 'number',
  name,
  value,
  ...range,
  step: 1,
  unit: 'count',
});

const turnField = ({ turn }: { readonly turn: number }): Field => ({
  kind: 'number',
  name: 'turn',
  value: turn * 45,
  min: 0,
  max: 315,
  step: 45,
  unit: 'deg',
});

/** What of an object can be changed by numbers and words, in the order of a list. */
export function fieldsOf(object: SceneObject): readonly Field[] {
  switch (object.type) {
    case 'wall':
      return [
        place('x', object.from[0]),
        place('y', object.from[1]),
        place('endX', object.to[0]),
        place('endY', object.to[1]),
        lengthMm('thickness', object.thickness, sceneLimits.thicknessMm, 1),
      ];
    case 'stroke':
      return strokeFields(object);
    case 'label':
      return labelFields(object);
    case 'block':
    case 'fixed-block':
    case 'spikes':
      return [{ kind: 'choice', name: 'type', value: object.type, choices: boxKinds }, ...boxFields(object)];
    case 'mover':
      return [
        ...boxFields(object),
        place('endX', object.to[0]),
        place('endY', object.to[1]),
        { kind: 'number', name: 'speed', value: object.speed, ...sceneLimits.speedMmS, step: 5, unit: 'mm/s' },
        { kind: 'switch', name: 'spiked', value: object.spiked },
      ];
    case 'target':
    case 'checkpoint':
    case 'forbidden':
      return [
        { kind: 'choice', name: 'type', value: object.type, choices: zoneKinds },
        ...(object.type === 'checkpoint' ? [count('number', object.number, sceneLimits.checkpoint)] : []),
        ...(object.type === 'target' ? [count('blocks', object.blocks, sceneLimits.blocks)] : []),
        ...boxFields(object),
        { kind: 'switch', name: 'round', value: object.round },
      ];
    default:
      return object satisfies never;
  }
}

function strokeFields({ points, width, color }: Stroke): readonly Field[] {
  const [first] = points;
  const last = points.length === 2 ? points[1] : undefined;
  return [
    ...(first ? [place('x', first[0]), place('y', first[1])] : []),
    ...(last ? [place('endX', last[0]), place('endY', last[1])] : []),
    lengthMm('penWidth', width, sceneLimits.widthMm, 1),
    { kind: 'choice', name: 'color', value: color, choices: strokeColors },
  ];
}

const labelFields = (label: Label): readonly Field[] => [
  { kind: 'text', name: 'text', value: label.text, maxCharacters: sceneLimits.labelCharacters },
  place('x', label.at[0]),
  place('y', label.at[1]),
  lengthMm('letterHeight', label.height, sceneLimits.labelMm, 5),
  turnField(label),
];

const boxFields = (box: Extract<SceneObject, { size: unknown }>): readonly Field[] => [
  place('x', box.at[0]),
  place('y', box.at[1]),
  lengthMm('width', box.size[0], sceneLimits.blockMm),
  lengthMm('height', box.size[1], sceneLimits.blockMm),
  turnField(box),
];

/** What of the robot's start can be changed by numbers. */
export const robotFields = ({ at, heading, scale }: RobotStart): readonly Field[] => [
  place('x', at[0]),
  place('y', at[1]),
  { kind: 'number', name: 'heading', value: heading, min: -180, max: 180, step: 15, unit: 'deg' },
  { kind: 'number', name: 'scale', value: scale, ...sceneLimits.scale, step: 0.25, unit: 'times' },
];
