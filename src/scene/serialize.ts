import {
  SCENE_FORMAT,
  SCENE_VERSION,
  sceneDefaults,
  type Background,
  type Label,
  type Mover,
  type Point,
  type RobotStart,
  type Scene,
  type SceneObject,
  type Stroke,
  type Task,
  type Wall,
  type Zone,
} from './scene';

/**
 * A course as its file: fixed order of properties, defaults left out, one object per line, ending in a newline.
 * Reading it back gives an equal scene, and the same scene always gives the same text.
 */
export function serializeScene(scene: Scene): string {
  const lines = [
    `"format": ${JSON.stringify(SCENE_FORMAT)}`,
    `"version": ${SCENE_VERSION}`,
    ...property('name', scene.name, ''),
    ...property('description', scene.description, ''),
    `"size": ${pair(scene.size)}`,
    ...property('board', scene.board, null),
    `"robot": ${robotText(scene.robot)}`,
    ...taskProperty(scene.task),
    ...backgroundProperty(scene.background),
  ];
  const objects = scene.objects.map((object) => `    ${objectText(object)}`).join(',\n');
  lines.push(objects === '' ? '"objects": []' : `"objects": [\n${objects}\n  ]`);
  return `{\n  ${lines.join(',\n  ')}\n}\n`;
}

const pair = (point: Point): string => `[${point[0]}, ${point[1]}]`;

type Plain = string | number | boolean | null;

/** No text at all for a value that is the default. */
function property(name: string, value: Plain, ifMissing: Plain): string[] {
  return value === ifMissing ? [] : [`"${name}": ${JSON.stringify(value)}`];
}

function robotText(robot: RobotStart): string {
  return braces([
    ...property('type', robot.type, null),
    `"at": ${pair(robot.at)}`,
    ...property('heading', robot.heading, sceneDefaults.heading),
    ...property('scale', robot.scale, sceneDefaults.scale),
    ...optionsProperty(robot.options),
  ]);
}

/** In the order of their ids, so that equal choices give equal text. */
function optionsProperty(options: RobotStart['options']): string[] {
  const entries = Object.entries(options).sort(([one], [other]) => (one < other ? -1 : 1));
  if (entries.length === 0) return [];
  return [`"options": ${braces(entries.map(([id, choice]) => `${JSON.stringify(id)}: ${JSON.stringify(choice)}`))}`];
}

function taskProperty({ seconds, noTouch }: Task): string[] {
  const standard = sceneDefaults.task;
  const task = [...property('seconds', seconds, standard.seconds), ...property('noTouch', noTouch, standard.noTouch)];
  return task.length === 0 ? [] : [`"task": ${braces(task)}`];
}

/** The long texts get lines of their own. */
function backgroundProperty(background: Background | null): string[] {
  if (background === null) return [];
  const { at, size, cells, levels, picture } = background;
  const lines = [
    `"at": ${pair(at)}`,
    `"size": ${pair(size)}`,
    `"cells": ${pair(cells)}`,
    `"levels": ${JSON.stringify(levels)}`,
    ...property('picture', picture, ''),
  ];
  return [`"background": {\n    ${lines.join(',\n    ')}\n  }`];
}

function objectText(object: SceneObject): string {
  const head = [`"id": ${JSON.stringify(object.id)}`, `"type": "${object.type}"`];
  switch (object.type) {
    case 'wall':
      return braces([...head, ...wallProperties(object)]);
    case 'block':
    case 'fixed-block':
    case 'spikes':
      return braces([...head, ...boxProperties(object)]);
    case 'stroke':
      return braces([...head, ...strokeProperties(object)]);
    case 'target':
    case 'checkpoint':
    case 'forbidden':
      return braces([...head, ...boxProperties(object), ...zoneProperties(object)]);
    case 'mover':
      return braces([...head, ...boxProperties(object), ...moverProperties(object)]);
    case 'label':
      return braces([...head, ...labelProperties(object)]);
    default:
      return object satisfies never;
  }
}

const braces = (properties: readonly string[]): string => `{ ${properties.join(', ')} }`;

const wallProperties = (wall: Wall): string[] => [
  `"from": ${pair(wall.from)}`,
  `"to": ${pair(wall.to)}`,
  ...property('thickness', wall.thickness, sceneDefaults.thickness),
];

const boxProperties = (box: { readonly at: Point; readonly size: Point; readonly turn: number }): string[] => [
  `"at": ${pair(box.at)}`,
  `"size": ${pair(box.size)}`,
  ...property('turn', box.turn, sceneDefaults.turn),
];

const zoneProperties = (zone: Zone): string[] => [
  ...property('round', zone.round, sceneDefaults.round),
  ...property('number', zone.number, 0),
  ...property('blocks', zone.blocks, sceneDefaults.blocks),
];

const moverProperties = (mover: Mover): string[] => [
  `"to": ${pair(mover.to)}`,
  ...property('speed', mover.speed, sceneDefaults.speed),
  ...property('spiked', mover.spiked, sceneDefaults.spiked),
];

const labelProperties = (label: Label): string[] => [
  `"at": ${pair(label.at)}`,
  `"text": ${JSON.stringify(label.text)}`,
  ...property('height', label.height, sceneDefaults.labelHeight),
  ...property('turn', label.turn, sceneDefaults.turn),
];

const strokeProperties = (stroke: Stroke): string[] => [
  `"points": [${stroke.points.map(pair).join(', ')}]`,
  ...property('width', stroke.width, sceneDefaults.width),
  ...property('color', stroke.color, sceneDefaults.color),
];
