import { braces, pair, property } from './json-text';
import { kindOf } from './kinds/index';
import {
  SCENE_FORMAT,
  SCENE_VERSION,
  sceneDefaults,
  type Background,
  type RobotStart,
  type Scene,
  type SceneObject,
  type Task,
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

/** One object in the form of a file. */
export const objectText = (object: SceneObject): string =>
  braces([`"id": ${JSON.stringify(object.id)}`, `"type": "${object.type}"`, ...kindOf(object).write(object)]);
