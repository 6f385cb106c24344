// The licences of everything that a bundle is made of, as one text.
import { readdirSync } from 'node:fs';
import { readdir, readFile } from 'node:fs/promises';
import { join, relative, sep } from 'node:path';
import { root } from './progress.mjs';

/** Modules of our own that are made from other files: those that say whose code is in them. */
const MADE_FROM = {
  '.cache/vm/vm.wasm': ['src/vm/NOTICE'],
  '.cache/vm/library.json': filesIn('src/vm/library'),
};

/** A notice in a comment of our own files: `@license NAME: TEXT`, up to the end of the comment. */
const NOTICE = /@license ([^:]+): ([^]+?)(?=\s*\*\/|\n[^ *#]|\s*$)/g;

/**
 * Gathers the licences of our own code, of each package with code in a bundle, and of what our files name with `@license`.
 *
 * @param {Iterable<string>} modules absolute paths of the bundle's modules; a query behind a path is ignored
 * @returns {Promise<string>} our own section, then one per package and notice, by name
 */
export async function licencesOf(modules) {
  const paths = [...modules].map((id) =>
    relative(root, id.replace(/^\0/, '').replace(/\?.*$/, '')).replaceAll(sep, '/'),
  );
  const packages = new Set(paths.map(packageOf).filter(Boolean));
  const own = new Set(paths.filter((path) => !path.startsWith('..') && packageOf(path) === undefined));
  const { version } = await about('');
  const first = `Parcours ${version}\n\n${await readFile(join(root, 'LICENSE'), 'utf8')}`;
  const sections = await Promise.all([...packages].map(licenceOfPackage));
  const rest = [...sections, ...(await noticesIn(own))].sort();
  return `${[first, ...rest].map((text) => text.trim()).join(`\n\n${'-'.repeat(80)}\n\n`)}\n`;
}

/** The folder of the package that a module belongs to, or undefined for one of our own. */
function packageOf(path) {
  const at = path.lastIndexOf('node_modules/');
  if (at < 0) return undefined;
  const [name, within] = path.slice(at + 'node_modules/'.length).split('/');
  return `${path.slice(0, at)}node_modules/${name.startsWith('@') ? `${name}/${within}` : name}`;
}

async function licenceOfPackage(folder) {
  const { name, version, license, author, homepage } = await about(folder);
  const files = (await readdir(join(root, folder))).filter((file) => /^(licen[cs]e|copying|notice)/i.test(file)).sort();
  const texts = await Promise.all(files.map((file) => readFile(join(root, folder, file), 'utf8')));
  if (texts.length === 0 && /MIT/.test(license)) texts.push(await mitTerms());
  const by = typeof author === 'object' ? author.name : author;
  const facts = [`${name} ${version}`, `Licence: ${license}`, by && `By: ${by}`, homepage && `See: ${homepage}`];
  return [facts.filter(Boolean).join('\n'), ...texts].join('\n\n');
}

/** The code and data of others in files of our own: one section for each name. */
async function noticesIn(paths) {
  const files = [...paths].flatMap((path) => MADE_FROM[path] ?? path);
  const notices = new Map();
  for (const file of files.sort())
    for (const [, name, text] of (await sourceOf(file)).matchAll(NOTICE))
      notices.set(name, new Set(notices.get(name)).add(text.replace(/\n[ *#]*/g, '\n')));
  const terms = await mitTerms();
  return [...notices].map(([name, texts]) => {
    const text = [...texts].join('\n');
    return `${name}\n\n${text}${text.includes('MIT') ? `\n\n${terms}` : ''}`;
  });
}

/** Virtual modules of the build's plugins have no file. */
const sourceOf = (path) => readFile(join(root, path), 'utf8').catch(() => '');

/** All files of a folder of ours. */
function filesIn(folder) {
  const all = readdirSync(join(root, folder), { recursive: true });
  return all.map((file) => `${folder}/${file.replaceAll(sep, '/')}`);
}

/** The terms of the MIT licence, for those who name it and bring no copy: as in our own. */
async function mitTerms() {
  const own = await readFile(join(root, 'LICENSE'), 'utf8');
  return own.slice(own.indexOf('Permission is hereby granted')).trim();
}

const about = async (folder) => JSON.parse(await readFile(join(root, folder, 'package.json'), 'utf8'));
