import { additionsOf } from './additions';
import { tidied } from './groups';
import { asAngle, asTurn, braces, pair, property, type Rotation } from './json-text';
import { ownHeightOf } from './kinds/heights';
import { kindOf } from './kinds/index';
import type { League, LeagueTile } from './league/league';
import { hasNews } from './news';
import { optionsProperty } from './robot-values';
import {
  SCENE_FORMAT,
  SCENE_VERSION,
  sceneDefaults,
  type Background,
  type RobotStart,
  type Scene,
  type SceneObject,
  type Task,
  type TaskCard,
  type TaskText,
} from './scene';

/**
 * A course as its file: fixed order of properties, defaults left out, one object per line, ending in a newline.
 * Reading it back gives an equal scene without groups of one, and the same scene always gives the same text. A course
 * is written in the oldest version that can say it, from 2 on, so that older apps open it as well.
 */
export function serializeScene(scene: Scene): string {
  const version = versionFor(scene);
  const lines = [
    `"format": ${JSON.stringify(SCENE_FORMAT)}`,
    `"version": ${version}`,
    ...property('name', scene.name, ''),
    ...property('description', scene.description, ''),
    `"size": ${pair(scene.size)}`,
    ...property('board', scene.board, null),
    `"robot": ${robotText(scene.robot)}`,
    ...taskProperty(scene.task),
    ...backgroundProperty(scene.background),
    ...leagueProperty(scene.league),
    ...property('ambient', scene.ambient ?? null, null),
  ];
  const rotation = version < 5 ? asTurn : asAngle;
  const objects = tidied(scene.objects)
    .map((object) => `    ${objectText(object, rotation)}`)
    .join(',\n');
  lines.push(objects === '' ? '"objects": []' : `"objects": [\n${objects}\n  ]`);
  return `{\n  ${lines.join(',\n  ')}\n}\n`;
}

function versionFor(scene: Scene): number {
  const { robot, task, objects } = scene;
  if (hasNews(scene)) return SCENE_VERSION;
  if (objects.some((object) => ownHeightOf(object) !== null)) return 7;
  if (robot.name !== undefined || robot.color !== undefined) return 6;
  if (tidied(objects).some((object) => Object.keys(additionsOf(object)).length > 0)) return 5;
  if (task.robots !== undefined || objects.some(({ type }) => type === 'start')) return 4;
  return task.allows === undefined && task.stars === undefined && task.card === undefined ? 2 : 3;
}

function robotText(robot: RobotStart): string {
  return braces([
    ...property('type', robot.type, null),
    `"at": ${pair(robot.at)}`,
    ...property('heading', robot.heading, sceneDefaults.heading),
    ...property('scale', robot.scale, sceneDefaults.scale),
    ...optionsProperty(robot.options),
    ...property('name', robot.name ?? '', ''),
    ...property('color', robot.color ?? null, null),
  ]);
}

/** The task on one line; a card, with its long texts, has lines of its own. */
function taskProperty({ seconds, noTouch, allows, robots, stars, card }: Task): string[] {
  const standard = sceneDefaults.task;
  const task = [
    ...property('seconds', seconds, standard.seconds),
    ...property('noTouch', noTouch, standard.noTouch),
    ...(allows === undefined ? [] : [`"allows": ${JSON.stringify(allows)}`]),
    ...(robots === undefined ? [] : [`"robots": "${robots}"`]),
    ...(stars === undefined ? [] : [`"stars": ${pair(stars)}`]),
  ];
  if (card !== undefined) return [`"task": {\n    ${[...task, `"card": ${cardText(card)}`].join(',\n    ')}\n  }`];
  return task.length === 0 ? [] : [`"task": ${braces(task)}`];
}

function cardText(card: TaskCard): string {
  const lines = [
    ...wordsText(card),
    ...(card.translations.length === 0
      ? []
      : [`"translations": [\n        ${card.translations.map(textText).join(',\n        ')}\n      ]`]),
    ...property('picture', card.picture, ''),
    ...property('solution', card.solution, false),
  ];
  return lines.length === 0 ? '{}' : `{\n      ${lines.join(',\n      ')}\n    }`;
}

const wordsText = ({ language, title, hints }: Pick<TaskText, 'language' | 'title' | 'hints'>): string[] => [
  ...property('language', language, ''),
  ...property('title', title, ''),
  ...(hints.length === 0 ? [] : [`"hints": ${JSON.stringify(hints)}`]),
];

/** A translation on one line; its language is always written. */
function textText({ language, title, text, hints }: TaskText): string {
  const words = wordsText({ language: '', title, hints });
  return braces([`"language": ${JSON.stringify(language)}`, ...words, ...property('text', text, '')]);
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

/** One tile per line. */
function leagueProperty(league: League | undefined): string[] {
  if (league === undefined) return [];
  const { rules, tiles, zone } = league;
  const lines = [
    `"rules": "${rules}"`,
    `"tiles": [\n      ${tiles.map(tileText).join(',\n      ')}\n    ]`,
    ...(zone === undefined ? [] : [`"zone": ${braces([`"at": ${pair(zone.at)}`, `"size": ${pair(zone.size)}`])}`]),
  ];
  return [`"league": {\n    ${lines.join(',\n    ')}\n  }`];
}

const tileText = ({ at, heading, gaps, crossings, obstacles, checkpoint, afterZone }: LeagueTile): string =>
  braces([
    `"at": ${pair(at)}`,
    ...property('heading', heading, 0),
    ...property('gaps', gaps ?? 0, 0),
    ...property('crossings', crossings ?? 0, 0),
    ...property('obstacles', obstacles ?? 0, 0),
    ...property('checkpoint', checkpoint ?? false, false),
    ...property('afterZone', afterZone ?? false, false),
  ]);

/** One object in the form of a file of the newest version, or with its rotation in the manner of an older one. */
export const objectText = (object: SceneObject, rotation: Rotation = asAngle): string =>
  braces([
    `"id": ${JSON.stringify(object.id)}`,
    `"type": "${object.type}"`,
    ...kindOf(object).write(object, rotation),
    ...property('lock', object.lock ?? false, false),
    ...property('group', object.group ?? null, null),
  ]);
