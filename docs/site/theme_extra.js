// In place of the theme's own, which Debian's mkdocs lacks: tables look as the theme has them.
for (const table of document.querySelectorAll(".rst-content table")) table.classList.add("docutils");
