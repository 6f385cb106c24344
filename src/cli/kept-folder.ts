import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { replaceFile } from './write-output';

/** A folder of results, one file each. Several processes may write into it: each file is written whole, or not at all. */
export class KeptFolder {
  constructor(private readonly path: string) {}

  /** Makes the folder if it does not exist. */
  make(): void {
    mkdirSync(this.path, { recursive: true });
  }

  /** All its files. */
  files(): readonly string[] {
    return existsSync(this.path) ? readdirSync(this.path).map((name) => join(this.path, name)) : [];
  }

  /** The data of a name, as it was written; a damaged file counts as missing: `null`. */
  find(name: string): unknown {
    try {
      return JSON.parse(readFileSync(this.fileOf(name), 'utf8'));
    } catch {
      return null;
    }
  }

  keep(name: string, data: object): void {
    replaceFile(this.fileOf(name), `${JSON.stringify(data)}\n`);
  }

  private fileOf(name: string): string {
    return join(this.path, `${name}.json`);
  }
}

/** Hash of everything that a result depends on. */
export const keyOf = (...parts: readonly unknown[]): string =>
  createHash('sha256').update(JSON.stringify(parts)).digest('hex');
