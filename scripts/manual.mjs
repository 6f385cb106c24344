// npm run manual: writes the tables of docs/embedding.md from the schemas of the dialects. `--check` only says whether they are up to date.
import { readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { toJsonSchema } from '@valibot/to-json-schema';
import prettier from 'prettier';
import { createServer } from 'vite';
import { Failure, main, note, root } from './progress.mjs';

const FILE = 'docs/embedding.md';
const DIALECTS = ['parcours', 'microbit', 'webtigerpython'];

/** The common fields of every message of ours are described once, above the tables. */
const LONG_TYPE = 160;

/**
 * The file with the part of each dialect written anew.
 *
 * @param {string} text the file as it is
 * @param {Readonly<Record<string, DialectManual>>} manuals by the dialect's folder
 */
export function withTables(text, manuals) {
  return Object.entries(manuals).reduce((before, [dialect, manual]) => {
    const [start, end] = [`<!-- ${dialect}:start, written by npm run manual -->`, `<!-- ${dialect}:end -->`];
    const [from, to] = [before.indexOf(start), before.indexOf(end)];
    if (from < 0 || to < from) throw new Failure(`${FILE} has no place for the dialect "${dialect}".`);
    return `${before.slice(0, from + start.length)}\n\n${tablesOf(manual)}\n\n${before.slice(to)}`;
  }, text);
}

/**
 * @typedef {{ name: string, direction: string, schema: object, about: string, answer?: object, since?: string }} ManualMessage
 * @typedef {{ title: string, version: string, messages: readonly ManualMessage[] }} DialectManual
 * @typedef {Record<string, any>} JsonSchema
 */

/** @param {DialectManual} manual */
function tablesOf({ messages }) {
  const parts = [
    ['From the host to the page', messages.filter(({ direction }) => direction === 'in')],
    ['From the page to the host', messages.filter(({ direction }) => direction === 'out')],
  ];
  return parts
    .filter(([, own]) => own.length > 0)
    .map(([title, own]) => `### ${title}\n\n${/** @type {ManualMessage[]} */ (own).map(messageOf).join('\n\n')}`)
    .join('\n\n');
}

/** @param {ManualMessage} message */
function messageOf({ name, about, schema, answer, since }) {
  const sentences = since === undefined ? about : `${about} _Since ${since}._`;
  const parts = [`#### \`${name}\``, sentences, tableOf(schema, 'Field', name)];
  if (answer !== undefined) parts.push('Its answer brings:', tableOf(answer, 'Field of the answer'));
  return parts.filter((part) => part !== '').join('\n\n');
}

/** @param {object} schema @param {string} heading @param {string} [name] of the message: the field that holds it says nothing new */
function tableOf(schema, heading, name) {
  const naming = `\`${JSON.stringify(name)}\``;
  const rows = rowsOf(jsonSchema(schema), '', true).filter(({ type }) => type !== naming);
  if (rows.length === 0) return '';
  const lines = rows.map(({ field, type, about }) => `| ${field} | ${cell(type)} | ${cell(about)} |`);
  return [`| ${heading} | type and range | meaning |`, '| --- | --- | --- |', ...lines].join('\n');
}

const cell = (text) => text.replaceAll('|', '\\|').replaceAll('\n', ' ');

/** @returns {JsonSchema} */
function jsonSchema(schema) {
  return toJsonSchema(schema, {
    errorMode: 'ignore',
    // What is judged elsewhere is called by its name.
    overrideSchema: ({ valibotSchema, jsonSchema: made }) => {
      const { type, class: own } = /** @type {any} */ (valibotSchema);
      const shown = metadataOf(valibotSchema).shown ?? (type === 'instance' ? own.name : undefined);
      return shown === undefined ? made : { ...made, shown };
    },
  });
}

/** @param {any} schema @returns {Record<string, any>} */
function metadataOf(schema) {
  const all = (schema.pipe ?? []).filter(({ type }) => type === 'metadata').map(({ metadata }) => metadata);
  return Object.assign({}, ...all);
}

/**
 * A row for every field, those of objects within it below it.
 *
 * @param {JsonSchema} schema @param {string} prefix @param {boolean} isNeeded
 * @returns {{ field: string, type: string, about: string }[]}
 */
function rowsOf(schema, prefix, isNeeded) {
  const choices = objectChoices(schema);
  if (choices.length > 1) {
    const seen = new Set();
    const all = choices.flatMap((choice) => rowsOf(choice, prefix, false));
    return all.filter(({ field, type }) => !seen.has(field + type) && seen.add(field + type));
  }
  const own = choices[0] ?? schema;
  const needed = new Set(own.required ?? []);
  return Object.entries(own.properties ?? {}).flatMap(([name, /** @type {JsonSchema} */ field]) => {
    const path = prefix === '' ? name : `${prefix}.${name}`;
    const isOptional = !isNeeded || !needed.has(name);
    const row = {
      field: `\`${path}\``,
      type: typeOf(field) + (isOptional ? ', may be left out' : ''),
      about: field.description ?? '',
    };
    const inner = field.type === 'array' && !Array.isArray(field.items) ? field.items : field;
    const innerPath = field.type === 'array' ? `${path}[]` : path;
    const hasFields = inner !== undefined && objectChoices(inner).some(({ properties }) => properties !== undefined);
    return hasFields && field.shown === undefined ? [row, ...rowsOf(inner, innerPath, true)] : [row];
  });
}

/** The objects that a schema may be. @param {JsonSchema} schema @returns {JsonSchema[]} */
function objectChoices(schema) {
  if (schema.properties !== undefined) return [schema];
  return (schema.anyOf ?? schema.oneOf ?? []).filter(({ properties }) => properties !== undefined);
}

/** @param {JsonSchema} schema @returns {string} */
function typeOf(schema) {
  if (schema.shown !== undefined) return schema.shown;
  if (schema.const !== undefined) return `\`${JSON.stringify(schema.const)}\``;
  if (schema.enum !== undefined) return valuesOf(schema.enum);
  const choices = schema.anyOf ?? schema.oneOf;
  if (choices !== undefined) return [...new Set(choices.map(typeOf))].join(' or ');
  switch (schema.type) {
    case 'object':
      return schema.additionalProperties ? `object of ${typeOf(schema.additionalProperties)}` : 'object';
    case 'array':
      return `list${Array.isArray(schema.items) ? '' : rangeOf(schema.minItems, schema.maxItems, 'entries')}${elementsOf(schema)}`;
    case 'string':
      return `text${rangeOf(schema.minLength, schema.maxLength, 'characters')}`;
    case 'integer':
      return `whole number${rangeOf(schema.minimum, schema.maximum, '')}`;
    case 'number':
      return `number${rangeOf(schema.minimum, schema.maximum, '')}`;
    case 'boolean':
      return '`true` or `false`';
    case 'null':
      return '`null`';
    default:
      return 'anything';
  }
}

function valuesOf(values) {
  const text = values.map((value) => `\`${JSON.stringify(value)}\``).join(', ');
  return text.length > LONG_TYPE ? `${text.slice(0, text.lastIndexOf(',', LONG_TYPE))}, …` : text;
}

/** @param {JsonSchema} schema */
function elementsOf({ items }) {
  if (Array.isArray(items)) return ` of ${String(items.length)} × ${typeOf(items[0])}`;
  return items === undefined || items.properties !== undefined ? '' : ` of ${typeOf(items)}`;
}

function rangeOf(min, max, unit) {
  if (min === undefined && max === undefined) return '';
  const word = unit === '' ? '' : ` ${unit}`;
  if (max === undefined) return `, from ${spaced(min)}${word}`;
  return min === undefined ? `, up to ${spaced(max)}${word}` : `, ${spaced(min)} … ${spaced(max)}${word}`;
}

const spaced = (value) => value.toLocaleString('en');

/** Reads the dialects' own lists; Vite does the TypeScript. @returns {Promise<Record<string, DialectManual>>} */
async function readManuals() {
  const server = await createServer({
    root,
    configFile: false,
    logLevel: 'error',
    appType: 'custom',
    server: { middlewareMode: true, ws: false, watch: null },
    optimizeDeps: { noDiscovery: true },
  });
  try {
    /** @type {Record<string, DialectManual>} */
    const manuals = {};
    for (const dialect of DIALECTS) {
      const exported = Object.values(await server.ssrLoadModule(`/src/embed/${dialect}/manual.ts`));
      manuals[dialect] = exported.find((value) => Array.isArray(value?.messages));
    }
    return manuals;
  } finally {
    await server.close();
  }
}

await main(import.meta.url, async (args) => {
  const path = join(root, FILE);
  const before = await readFile(path, 'utf8');
  const written = withTables(before, await readManuals());
  const options = await prettier.resolveConfig(path);
  const after = await prettier.format(written, { ...options, filepath: path });
  if (args.includes('--check')) {
    if (before !== after) throw new Failure(`${FILE} is out of date: npm run manual writes it anew.`);
    return;
  }
  if (before !== after) await writeFile(path, after);
  note(before === after ? `${FILE} is up to date.` : `${FILE} is written anew.`);
});
