// What the ordinary page says where it cannot start: in frames without an origin of their own (decision 0018).
import { createHash } from 'node:crypto';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { root } from './progress.mjs';

const FOLDER = 'src/web/app/frame-check';

/**
 * The parts of the check: a classic script, styles and the sentence in four languages.
 *
 * @returns {Promise<{ script: string, css: string, html: string }>}
 */
export async function frameCheckParts() {
  const read = async (ending) =>
    (await readFile(join(root, FOLDER, `frame-check.${ending}`), 'utf8')).replace(/\r\n/g, '\n').trim();
  const html = await read('html');
  const css = await read('css');
  return {
    script: await read('js'),
    css: css.replace(/\s*\n\s*/g, ''),
    html: html.replace(/\s+/g, ' ').replace(/> </g, '><'),
  };
}

/** A script's source for a content policy. @param {string} script */
export const scriptHash = (script) => `'sha256-${createHash('sha256').update(script).digest('base64')}'`;

/**
 * The page with the check inside: the sentence stands where the app takes its place.
 *
 * @param {string} page
 * @param {{ script: string, css: string, html: string }} parts
 * @throws Error where the page does not look as expected
 */
export function withFrameCheck(page, { script, css, html }) {
  let result = page;
  const put = (pattern, replacement) => {
    if (!pattern.test(result)) throw new Error(`The page has nothing like ${pattern}.`);
    result = result.replace(pattern, replacement);
  };
  put(/script-src 'self'/, (self) => `${self} ${scriptHash(script)}`);
  put(/<\/title>/, (title) => `${title}\n    <style>${css}</style>\n    <script>${script}</script>`);
  put(/<div id="app">/, (app) => app + html);
  return result;
}
