/**
 * Keeps what a build has drawn in the cache of the tools, so that no build draws it again, and neither does a fresh clone. A file's
 * name is the digest of all that it is made of, and its first bytes are the digest of the rest: a damaged one is drawn anew.
 */

import { createHash } from "node:crypto";
import { mkdirSync, readdirSync, readFileSync, renameSync, rmSync, statSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";

/** Engines of which pictures stay: the checkouts of one machine may differ in theirs. */
const ENGINES = 4;
const DIGEST_BYTES = 32;

/** Files that are made of the same engine and code. Without a folder, as where no environment names the cache, none is kept. */
export class Kept {
  readonly #folder: string | undefined;

  constructor(cache: string | undefined, makers: readonly (string | Uint8Array)[]) {
    this.#folder = cache && join(cache, "maps", digestOf(makers).toString("hex"));
  }

  /** Returns the file of some parts, if there is one and it is undamaged. */
  file(parts: readonly string[]): Uint8Array | undefined {
    if (this.#folder === undefined) return undefined;
    try {
      const sealed = readFileSync(placeIn(this.#folder, parts));
      const file = sealed.subarray(DIGEST_BYTES);
      return digestOf([file]).equals(sealed.subarray(0, DIGEST_BYTES)) ? file : undefined;
    } catch {
      return undefined;
    }
  }

  /** Keeps a file. It is renamed into place, so that another build at the same time finds it complete or not at all. */
  keep(parts: readonly string[], file: Uint8Array): void {
    if (this.#folder === undefined) return;
    if (mkdirSync(this.#folder, { recursive: true })) forgetOld(dirname(this.#folder));
    const place = placeIn(this.#folder, parts);
    const unfinished = `${place}.${process.pid}`;
    writeFileSync(unfinished, Buffer.concat([digestOf([file]), file]));
    renameSync(unfinished, place);
  }
}

/** Removes what all but the last engines have drawn. */
function forgetOld(folder: string): void {
  const made = (engine: string): number => statSync(join(folder, engine), { throwIfNoEntry: false })?.mtimeMs ?? 0;
  const old = readdirSync(folder)
    .sort((one, other) => made(other) - made(one))
    .slice(ENGINES);
  for (const engine of old) rmSync(join(folder, engine), { recursive: true, force: true });
}

function placeIn(folder: string, parts: readonly string[]): string {
  return join(folder, digestOf(parts).toString("hex"));
}

/** Returns the digest of some parts, each with its length: what moves from one to the next makes another digest. */
function digestOf(parts: readonly (string | Uint8Array)[]): Buffer {
  const digest = createHash("sha256");
  for (const part of parts) digest.update(`${Buffer.byteLength(part)} `).update(part);
  return digest.digest();
}
