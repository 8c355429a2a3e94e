// How the bundle is made: index.html, app.js, app.css, favicon.svg and shape_scene.js, which only the
// page that draws in space loads, under fixed names, nothing inline (the server's
// Content-Security-Policy forbids it), licences of bundled packages in front.
import { readFileSync } from 'node:fs';
import { defineConfig } from 'vite';
import type { Plugin } from 'vite';

const packages: Record<string, string[]> = { 'app.js': ['preact', 'uplot'], 'shape_scene.js': ['three'] };

function licencesOf(names: string[]): string {
  const texts = names.map((name) => {
    const folder = new URL(`node_modules/${name}/`, import.meta.url);
    const { version } = JSON.parse(readFileSync(new URL('package.json', folder), 'utf8'));
    return `${name} ${version}\n${readFileSync(new URL('LICENSE', folder), 'utf8').trim()}`;
  });
  return `/*! Tetfarm's dashboard, BSD-3-Clause. It contains:\n\n${texts.join('\n\n')}\n*/\n`;
}

/** After minifying, which would drop it otherwise. */
function licenceBanner(): Plugin {
  return {
    name: 'licence-banner',
    enforce: 'post',
    generateBundle(_options, bundle) {
      for (const file of Object.values(bundle)) {
        if (file.type !== 'chunk') continue;
        const names = packages[file.fileName];
        if (!names) throw new Error(`which packages are in ${file.fileName}?`);
        file.code = licencesOf(names) + file.code;
      }
    },
  };
}

export default defineConfig({
  base: '/',
  plugins: [licenceBanner()],
  build: {
    outDir: process.env.TETFARM_WEB_OUT || 'dist',
    emptyOutDir: true,
    target: ['chrome109', 'firefox115', 'safari16'],
    cssCodeSplit: false,
    assetsInlineLimit: 0,
    modulePreload: false,
    rollupOptions: {
      output: {
        entryFileNames: 'app.js',
        chunkFileNames: '[name].js',
        assetFileNames: 'app[extname]',
      },
    },
  },
  server: {
    proxy: { '/api': process.env.TETFARM_DASHBOARD_URL || 'http://127.0.0.1:8710' },
  },
});
