import {
  SCENE_FORMAT,
  SCENE_VERSION,
  sceneDefaults,
  type Block,
  type Point,
  type RobotStart,
  type Scene,
  type SceneObject,
  type Stroke,
  type Wall,
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
  ];
  const objects = scene.objects.map((object) => `    ${objectText(object)}`).join(',\n');
  lines.push(objects === '' ? '"objects": []' : `"objects": [\n${objects}\n  ]`);
  return `{\n  ${lines.join(',\n  ')}\n}\n`;
}

const pair = (point: Point): string => `[${point[0]}, ${point[1]}]`;

/** No text at all for a value that is the default. */
function property(name: string, value: string | number | null, ifMissing: string | number | null): string[] {
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

function objectText(object: SceneObject): string {
  const head = [`"id": ${JSON.stringify(object.id)}`, `"type": "${object.type}"`];
  switch (object.type) {
    case 'wall':
      return braces([...head, ...wallProperties(object)]);
    case 'block':
    case 'fixed-block':
      return braces([...head, ...blockProperties(object)]);
    case 'stroke':
      return braces([...head, ...strokeProperties(object)]);
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

const blockProperties = (block: Block): string[] => [
  `"at": ${pair(block.at)}`,
  `"size": ${pair(block.size)}`,
  ...property('turn', block.turn, sceneDefaults.turn),
];

const strokeProperties = (stroke: Stroke): string[] => [
  `"points": [${stroke.points.map(pair).join(', ')}]`,
  ...property('width', stroke.width, sceneDefaults.width),
  ...property('color', stroke.color, sceneDefaults.color),
];
