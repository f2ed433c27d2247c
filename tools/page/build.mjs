// Builds quadruped_env/walking_page/assets from src and the pinned packages. Usage: npm ci && npm run build

import { createHash } from 'node:crypto';
import fs from 'node:fs';
import path from 'node:path';
import { gzipSync } from 'node:zlib';
import { build } from 'esbuild';
import { withoutEval } from './without-eval.mjs';

const here = import.meta.dirname, assets = path.join(here, '../../quadruped_env/walking_page/assets');
const read = (...parts) => fs.readFileSync(path.join(here, ...parts));
const packages = ['@mujoco/mujoco', 'three'];
const sha256 = (bytes) => createHash('sha256').update(bytes).digest('hex');

const banner = `/*
This file contains MuJoCo, Copyright DeepMind Technologies Limited, licensed under the Apache License, Version 2.0
(https://www.apache.org/licenses/LICENSE-2.0), and three.js:

${read('node_modules/three/LICENSE')}*/`;

const bundled = async (file, options) => (await build({
  entryPoints: [path.join(here, file)],
  bundle: true, minify: true, format: 'esm', target: 'es2022', charset: 'utf8', legalComments: 'none', write: false, banner: { js: banner }, plugins: [withoutEval],
  // MuJoCo's loader imports them in Node.js alone.
  external: ['module', 'node:*', 'fs', 'path', 'url', 'worker_threads', 'crypto'],
  ...options,
})).outputFiles[0].text;
// Pages from the disk start no workers that are modules; a script has no address that MuJoCo could take.
const workerOptions = { format: 'iife', define: { 'import.meta.url': '"file:///"' } };
const style = await build({ entryPoints: [path.join(here, 'src/style.css')], minify: true, write: false });
const outputs = {
  // Within the page, this would end the script's element.
  'page.js': (await bundled('src/page.mjs')).replaceAll('</script', '<\\/script'),
  'page.css': style.outputFiles[0].text,
  'page.html': read('src/index.html'),
  'worker.js.gz': gzipSync(await bundled('src/learn/worker.mjs', workerOptions), { level: 9 }),
  'mujoco.wasm.gz': gzipSync(read('node_modules/@mujoco/mujoco/mujoco.wasm'), { level: 9 }),
};
const version = (name) => JSON.parse(read('node_modules', name, 'package.json')).version;
const sourceFiles = fs.readdirSync(path.join(here, 'src'), { recursive: true, withFileTypes: true })
  .filter((entry) => entry.isFile()).map((entry) => path.relative(here, path.join(entry.parentPath, entry.name))).sort();
const sources = ['package.json', 'package-lock.json', 'build.mjs', 'without-eval.mjs', ...sourceFiles];
const built = {
  packages: Object.fromEntries(packages.map((name) => [name, version(name)])),
  sources: Object.fromEntries(sources.map((name) => [name, sha256(read(name))])),
  outputs: Object.fromEntries(Object.entries(outputs).map(([name, content]) => [name, sha256(content)])),
};
fs.mkdirSync(assets, { recursive: true });
for (const [name, content] of Object.entries(outputs)) fs.writeFileSync(path.join(assets, name), content);
fs.writeFileSync(path.join(assets, 'built.json'), `${JSON.stringify(built, null, 2)}\n`);
for (const [name, content] of Object.entries(outputs)) console.log(name, content.length);
