import type { Pose } from '#core/geometry';
import type { Scene } from '#scene/scene';
import type { Outline } from '#scene/outline';

import kindNames from '../../course/editor/words/kinds';
import { valueText } from '../../course/editor/words/value-text';
import { t } from '../../kit/i18n';
import type { Moment } from './moment';
import words from './words';
import type { News } from './news';
import { isNear } from './watch-ahead';
import { fromRobot, nearestSolid, deepestSolid, type Solid } from './solids';

/** The course in which the robot drives. */
export interface Surroundings {
  readonly scene: Scene;
  /** The convex parts of the robot's body in its frame, at its size. */
  readonly body: readonly Outline[];
}

/**
 * The announcement of a piece of news, in up to three sentences.
 *
 * @param now the newest moment: what has changed since it was seen is said as it is now
 * @returns `null`: it is not so any more
 */
export function sentence(news: News, now: Moment, { scene, body }: Surroundings): string | null {
  switch (news.topic) {
    case 'start':
      return together(
        poseText(news.isOnWay ? 'here' : 'start', (news.isOnWay ? now : news.seen).pose),
        aheadText(now, scene),
        onLineAtStart(now, scene),
      );
    case 'rest':
      return together(poseText('rest', now.pose), aheadText(now, scene));
    case 'touch':
      return touchText(news.seen, { scene, body });
    case 'checkpoint':
      return t(words.checkpoint, { number: news.number });
    case 'target':
    case 'block':
      return t(news.of === 1 ? words[news.topic] : words[`${news.topic}s`], { done: news.done, of: news.of });
    case 'line':
      return lineText(news.names, now, scene);
    case 'colour':
      return t(words.colour[news.side], { name: valueText(news.name) });
    case 'camera':
      if (news.isLine) return t(words.camera.line);
      return news.ids.length === 0 ? t(words.camera.none) : t(words.camera.things, { ids: news.ids.join(', ') });
    case 'ahead':
      if (news.isClear) return isNear(now) ? null : t(words.clear);
      return isNear(now) ? aheadText(now, scene) : null;
    case 'turn':
      return turnText(news);
    default:
      return news satisfies never;
  }
}

const together = (...parts: readonly (string | null)[]): string => parts.filter((part) => part !== null).join(' ');

/** The robot's place and heading. */
export const poseText = (which: 'start' | 'here' | 'rest', pose: Pose): string =>
  t(words[which], {
    x: Math.round(pose.xMm / 10),
    y: Math.round(pose.yMm / 10),
    heading: wholeDegrees(pose.headingRad),
  });

/** As the program and the course count them: counter-clockwise from the right, −179 … 180. */
function wholeDegrees(rad: number): number {
  const degrees = Math.round((rad * 180) / Math.PI) % 360;
  return (degrees > 180 ? degrees - 360 : degrees <= -180 ? degrees + 360 : degrees) + 0;
}

/**
 * The words on the thing ahead, with the distance that the sensor reports; `null`: nothing in range, or no such sensor.
 */
function aheadText({ ahead, moved }: Moment, scene: Scene): string | null {
  if (ahead === undefined || ahead === null) return null;
  const met = ahead.hitMm === null ? 'wall' : nearestSolid(ahead.hitMm, scene, moved).what;
  return t(words.ahead, { thing: nameOf(met), cm: Math.round(ahead.mm / 10) });
}

const nameOf = (what: Solid): string => t(what === 'edge' ? words.edge : kindNames[what].one);

/** By eighths of a turn, counter-clockwise. */
const SIDES = ['front', 'front-left', 'left', 'back-left', 'back', 'back-right', 'right', 'front-right'] as const;

function touchText({ pose, moved }: Moment, { scene, body }: Surroundings): string {
  const { what, atMm } = deepestSolid(body, pose, scene, moved);
  const { x, y } = fromRobot(pose, atMm);
  const eighth = ((Math.round(Math.atan2(y, x) / (Math.PI / 4)) % 8) + 8) % 8;
  return t(words.touch[SIDES[eighth] ?? 'front'], { thing: t(words.touched[what]) });
}

/** True if the course has lines and no floor picture, on which a sensor's darkness need not mean a line. */
const hasLines = ({ objects, background }: Scene): boolean =>
  background === null && objects.some(({ type }) => type === 'stroke');

/** The words on the sensors that are on the line. */
function lineText(names: readonly string[], { lineSensors }: Moment, scene: Scene): string {
  const texts = hasLines(scene) ? words.line : words.dark;
  if (names.length === 0) return t(texts.none);
  const isPair = lineSensors.length === 2;
  if (names.length === lineSensors.length) return t(isPair ? texts.both : texts.all);
  if (isPair) return t(names[0] === lineSensors[0]?.name ? texts.left : texts.right);
  return t(texts.some, { names: names.join(', ') });
}

function onLineAtStart(now: Moment, scene: Scene): string | null {
  const names = now.lineSensors.flatMap(({ name, isDark }) => (isDark ? [name] : []));
  return names.length === 0 ? null : lineText(names, now, scene);
}

function turnText({ isLeft, degrees }: Extract<News, { topic: 'turn' }>): string {
  if (degrees === null) return t(isLeft ? words.turn.left : words.turn.right);
  return t(isLeft ? words.turn.leftBy : words.turn.rightBy, { degrees });
}
