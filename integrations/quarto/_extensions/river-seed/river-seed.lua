-- The shortcode of Quarto: {{< river-seed kauri >}}. It draws each picture once, with the command `riverseed`, into the folder riverseed
-- of the project, where the element's files are.

-- The longer side of the picture, a PNG of some 600 kB.
local SIZE = "960"
-- Pixels of a screen to a CSS pixel, in a column of 640: letters are large enough to be read.
local RATIO = "1.5"

local function fail(message)
  error("river-seed: " .. message, 0)
end

local function escaped(text)
  return (text:gsub("[&<>\"']", function(sign) return "&#" .. sign:byte() .. ";" end))
end

-- Asks the command, without a shell, so that no word is read as one. What is wrong with a map the command says itself.
local function asked(map, words)
  local is_done, why = pcall(pandoc.pipe, "riverseed", words, "")
  if is_done then return why end
  if type(why) == "table" and why.error_code ~= 127 then fail('no map of "' .. map .. '": see above') end
  fail("the command `riverseed` cannot be run: " .. tostring(why))
end

-- Returns the size that a PNG says it has; nothing if there is none.
local function size_of(path)
  local file = io.open(path, "rb")
  if not file then return end
  local head = file:read(24)
  file:close()
  return string.unpack(">I4I4", head, 17)
end

-- Reads a map as the command does: the canonical link, whose edition keeps the picture and the element alike after an upgrade, a text
-- alternative, and what the element cannot draw.
local function read(map)
  return quarto.json.decode(asked(map, { "embed", "--json", "--", map }))
end

-- Returns the file name and the size of a map's picture in a folder. The name is a hash of all that decides the pixels.
local function picture(map, link, folder)
  local pixels = ("%s, %s at %s"):format(link, SIZE, RATIO)
  local name = "river-seed-" .. pandoc.utils.sha1(pixels):sub(1, 16) .. ".png"
  if not size_of(folder .. name) then
    asked(map, { "render", link, "-o", folder .. name, "--size", SIZE, "--ratio", RATIO })
  end
  return name, size_of(folder .. name)
end

local function river_seed(args, kwargs)
  local map = pandoc.utils.stringify(args[1] or "")
  local own_alt = pandoc.utils.stringify(kwargs.alt or "")
  if map:match("^%s*$") then fail('a word or a link is wanted, as "kauri" or "seed=kauri&land=valley"') end
  if map:match("%c") then fail("the map holds a character that cannot be shown") end
  local folder = (quarto.project.directory or ".") .. "/riverseed/"
  if not io.open(folder .. "river-seed.js") then fail("the element's files are not in the folder riverseed of the project") end

  local facts = read(map)
  local link = facts.link
  local name, width, height = picture(map, link, folder)
  local base = (quarto.project.offset or ".") .. "/riverseed/"
  local alt = own_alt ~= "" and own_alt or facts.alternative
  local beyond = table.concat(facts.beyond_element, "; ")
  if beyond ~= "" then io.stderr:write('river-seed: a picture without the element for "', map, '": ', beyond, "\n") end
  if not quarto.doc.is_format("html") then return pandoc.Image({ pandoc.Str(alt) }, base .. name) end
  local img = table.concat({
    '<img src="', base, name, '" alt="', escaped(alt), '" width="', width, '" height="', height, '" style="display:block;width:100%;height:auto">',
  })
  if beyond ~= "" then return pandoc.RawInline("html", img) end
  return pandoc.RawInline("html", table.concat({
    '<script type="module" src="', base, 'river-seed.js"></script>',
    '<river-seed recipe="', escaped(link), '"', own_alt ~= "" and ' alt="' .. escaped(alt) .. '"' or "", ' style="display:block">',
    img, '</river-seed>',
  }))
end

return { ["river-seed"] = river_seed }
