import { PICTURE, readBase64 } from './read-base64';
import type { Reader } from './reader';
import {
  helps,
  sceneDefaults,
  sceneLimits,
  taskRules,
  type Help,
  type Task,
  type TaskCard,
  type TaskText,
} from './scene';

/** Reads the task of a course. What the file leaves out of allowances, sharing, stars and card stays
 * left out. */
export function readTask(value: unknown, path: string, reader: Reader): Task {
  const { seconds, noTouch, allows, robots, stars, card } = reader.fields(value, path, [
    ...['seconds', 'noTouch', 'allows', 'robots', 'stars', 'card'],
  ]);
  const standard = sceneDefaults.task;
  return {
    seconds:
      seconds === undefined || seconds === null
        ? standard.seconds
        : reader.number(seconds, `${path}.seconds`, sceneLimits.seconds),
    noTouch: reader.flag(noTouch, `${path}.noTouch`, standard.noTouch),
    ...(allows === undefined ? {} : { allows: readHelps(allows, `${path}.allows`, reader) }),
    ...(robots === undefined ? {} : { robots: reader.word(robots, `${path}.robots`, taskRules, 'all') }),
    ...(stars === undefined ? {} : { stars: readStars(stars, `${path}.stars`, reader) }),
    ...(card === undefined ? {} : { card: readCard(card, `${path}.card`, reader) }),
  };
}

function readHelps(value: unknown, path: string, reader: Reader): readonly Help[] {
  const entries = reader.list(value, path, { min: 0, max: helps.length });
  return entries.map((entry, index) => reader.word(entry, `${path}[${index}]`, helps, 'hand'));
}

function readStars(value: unknown, path: string, reader: Reader): NonNullable<Task['stars']> {
  const [two, three] = reader.list(value, path, { min: 2, max: 2 });
  return [
    reader.number(two, `${path}[0]`, sceneLimits.seconds),
    reader.number(three, `${path}[1]`, sceneLimits.seconds),
  ];
}

function readCard(value: unknown, path: string, reader: Reader): TaskCard {
  const fields = reader.fields(value, path, Object.keys(sceneDefaults.card));
  const { languageCharacters, titleCharacters, translations: max, taskPictureCharacters } = sceneLimits;
  const { picture, translations = [] } = fields;
  const texts = reader.list(translations, `${path}.translations`, { min: 0, max });
  return {
    language: reader.text(fields.language, `${path}.language`, languageCharacters, ''),
    title: reader.text(fields.title, `${path}.title`, titleCharacters, ''),
    hints: readHints(fields.hints, `${path}.hints`, reader),
    translations: texts.map((text, index) => readText(text, `${path}.translations[${index}]`, reader)),
    picture:
      picture === undefined || picture === ''
        ? ''
        : readBase64(picture, `${path}.picture`, PICTURE, reader, taskPictureCharacters),
    solution: reader.flag(fields.solution, `${path}.solution`, false),
  };
}

function readText(value: unknown, path: string, reader: Reader): TaskText {
  const fields = reader.fields(value, path, ['language', 'title', 'text', 'hints']);
  const { languageCharacters, titleCharacters, descriptionCharacters } = sceneLimits;
  return {
    language: reader.text(fields.language, `${path}.language`, languageCharacters),
    title: reader.text(fields.title, `${path}.title`, titleCharacters, ''),
    text: reader.text(fields.text, `${path}.text`, descriptionCharacters, ''),
    hints: readHints(fields.hints, `${path}.hints`, reader),
  };
}

function readHints(value: unknown, path: string, reader: Reader): readonly string[] {
  const { hints: max, hintCharacters } = sceneLimits;
  const entries = value === undefined ? [] : reader.list(value, path, { min: 0, max });
  return entries.map((entry, index) => reader.text(entry, `${path}[${index}]`, hintCharacters));
}
