// An esbuild plugin: MuJoCo's loader without `new Function`, which a strict content security policy forbids.
//
// Emscripten's embind writes the functions that convert arguments as text, unless it was built with DYNAMIC_EXECUTION=0.

import fs from 'node:fs';

const REPLACEMENTS = [
  [
    'var invokerFn = new Function(...args, invokerFnBody)(...closureArgs);',
    `var first = isClassMethodFunc ? 1 : 2;
    var invokerFn = function (...given) {
      checkArgCount(given.length, minArgs, expectedArgCount, humanName, throwBindingError);
      var destructors = needsDestructorStack ? [] : null;
      var wired = isClassMethodFunc ? [argTypes[1].toWireType(destructors, this)] : [];
      for (var i = 0; i < expectedArgCount; ++i) wired.push(argTypes[i + 2].toWireType(destructors, given[i]));
      var rv = cppInvokerFunc(cppTargetFunc, ...wired);
      if (needsDestructorStack) runDestructors(destructors);
      else for (var i = first; i < argTypes.length; ++i) argTypes[i].destructorFunction?.(wired[i - first]);
      if (returns) return argTypes[0].fromWireType(rv);
    };`,
  ],
  ['let [args, invokerFnBody] = createJsInvoker(argTypes, isClassMethodFunc, returns, isAsync);', ''],
  [
    'var invokerFunction = new Function(...params, functionBody)(...args);',
    `var invokerFunction = (obj, func, destructorsRef, at) => {
      var given = kind === 0 ? [obj] : [];
      for (var i = 0; i < argCount; ++i) {
        given.push(types[i].readValueFromPointer(at));
        at += types[i].argPackAdvance;
      }
      var rv = kind === 1 ? new func(...given) : func.call(...given);
      if (!retType.isVoid) return emval_returnValue(retType, destructorsRef, rv);
    };`,
  ],
];

export const withoutEval = {
  name: 'without-eval',
  setup(build) {
    build.onLoad({ filter: /@mujoco\/mujoco\/mujoco\.js$/ }, ({ path }) => {
      let contents = fs.readFileSync(path, 'utf8');
      for (const [old, replacement] of REPLACEMENTS) {
        if (contents.split(old).length !== 2) throw new Error(`${path}: expected once: ${old}`);
        contents = contents.replace(old, () => replacement);
      }
      if (/\bnew Function\b|\beval\(/.test(contents)) throw new Error(`${path}: still evaluates text`);
      return { contents };
    });
  },
};
