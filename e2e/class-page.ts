import { readFileSync } from 'node:fs';
import { linkOf } from '../src/project/link/link';
import { defaultScene } from '../src/scene/scene';
import type { App } from './app';
import { by, until } from './parts';

/** A program that passes the course with the closed line, and one that is too slow for it and leaves the line. */
export const RIGHT = readFileSync('courses/closed-line/main.py', 'utf8');
export const CREEP = `from mbrobot import *\nsetSpeed(20)\nforward()\ndelay(15000)\nstop()\n`;

/** The link of a program, as pupils send it. */
export function linkTo(text: string): string {
  const made = linkOf(
    { files: [{ name: 'main.py', text }], scene: defaultScene(), course: null },
    { courses: () => null, program: true },
  );
  return `https://example.org/#${made?.fragment ?? ''}`;
}

/** Opens the page that checks a class, in German, and chooses the task. */
export async function openClass(app: App, task: string): Promise<void> {
  await app.goto('./logo.svg');
  await app.evaluate(() =>
    localStorage.setItem('parcours.settings', JSON.stringify({ language: 'de', welcomed: true })),
  );
  await app.goto('./#class');
  await until(app, by('class-task'));
  await select(app, 'class-task', task);
}

/** As a hand at a select: the browsers' own lists are no part of the page. */
export const select = (app: App, id: string, value: string): Promise<void> =>
  app.evaluate(
    (wish) => {
      const field = document.querySelector<HTMLSelectElement>(`[data-testid=${wish.id}]`)!;
      field.value = wish.value;
      field.dispatchEvent(new Event('change', { bubbles: true }));
    },
    { id, value },
  );

/** Pastes somewhere on the page, into no field. */
export const paste = (app: App, text: string): Promise<void> =>
  app.evaluate((pasted) => {
    const event = new Event('paste', { bubbles: true, cancelable: true });
    const getData = (type: string) => (type === 'text/plain' ? pasted : '');
    Object.defineProperty(event, 'clipboardData', { value: { getData, files: [] } });
    document.body.dispatchEvent(event);
  }, text);
